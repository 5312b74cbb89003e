// Where a ray meets a box, a triangle, a sphere or a plane.
//
// The sign of a difference of products decides between hit and miss here. Rounding alone never flips such a
// sign; it can only make the difference zero, which counts as inside. Contraction and reordering can flip it,
// so compilers are forbidden both in all of the shaders' arithmetic (host/shader_compiler/exact_spirv.hpp).
//
// A ray is o + t d, where d may have any length; a hit has 0 < t < infinity. The tests are written so that a
// NaN fails them.
#ifndef INTERSECT_GLSL
#define INTERSECT_GLSL

#include "vector.glsl"

struct Ray {
  vec3 origin;
  vec3 direction;
};

// A ray as the triangle test needs it, in axes of which z is the main one.
struct ShearedRay {
  vec3 origin;
  vec3 shear;      // the direction, scaled by a power of two so that 1 <= |shear.z| < 2
  float inverseZ;  // 1 / the unscaled z component
};

// Rotates the components so that `axis` becomes z.
vec3 permute(vec3 v, uint axis) {
  return axis == 2u ? v : (axis == 1u ? v.zxy : v.yzx);
}

// A device may treat denormal numbers as zero; this makes every device do so. In a direction the inverse of a
// denormal number is infinite, so that it would bound the ray at sides where zero sets no bound; in an origin
// it would keep such a ray out of a box that it touches.
vec3 withoutDenormals(vec3 v) {
  return mix(vec3(0.0), v, greaterThanEqual(abs(v), vec3(kMinNormal)));
}
Ray withoutDenormals(Ray ray) {
  return Ray(withoutDenormals(ray.origin), withoutDenormals(ray.direction));
}

// The axis of the direction's largest component.
uint mainAxis(vec3 direction) {
  const vec3 size = abs(direction);
  return size.z >= size.x && size.z >= size.y ? 2u : (size.y >= size.x ? 1u : 0u);
}

// The ray must have no denormal numbers, and `axis` must be its main one.
ShearedRay shearedRay(Ray ray, uint axis) {
  const vec3 direction = permute(ray.direction, axis);
  // 2^-e for |z| = m 2^e, by its exponent bits: e becomes -e.
  const uint exponentBits = floatBitsToUint(direction.z) & 0x7F800000u;
  const vec3 shear = direction * uintBitsToFloat(0x7F000000u - exponentBits);
  return ShearedRay(permute(ray.origin, axis), shear, 1.0 / direction.z);
}

// The distance to the triangle, or infinity; `weights` are the barycentric coordinates of a, b, c, which are
// in the ray's axes.
//
// The triangle is sheared into coordinates in which the ray is the z axis, and the signs of the areas that
// this axis spans with each edge are compared. Two triangles that share an edge compute the same products for
// it, so no ray passes between them.
//
// Based on: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013; without its
// double-precision fallback, which only takes back hits on edges, and multiplying by the shear's z in place
// of dividing by it. So the vertices of a scene in round numbers are sheared exactly, and the ray through a
// pixel's centre hits an edge that it lies on.
float intersectTriangle(ShearedRay ray, vec3 a, vec3 b, vec3 c, out vec3 weights) {
  const vec3 localA = a - ray.origin;
  const vec3 localB = b - ray.origin;
  const vec3 localC = c - ray.origin;
  const vec2 shearedA = localA.xy * ray.shear.z - ray.shear.xy * localA.z;
  const vec2 shearedB = localB.xy * ray.shear.z - ray.shear.xy * localB.z;
  const vec2 shearedC = localC.xy * ray.shear.z - ray.shear.xy * localC.z;
  const vec3 areas = vec3(shearedC.x * shearedB.y - shearedC.y * shearedB.x,
                          shearedA.x * shearedC.y - shearedA.y * shearedC.x,
                          shearedB.x * shearedA.y - shearedB.y * shearedA.x);
  weights = vec3(0.0);
  if (any(lessThan(areas, vec3(0.0))) && any(greaterThan(areas, vec3(0.0)))) return kInfinity;
  const float sum = areas.x + areas.y + areas.z;
  if (sum == 0.0) return kInfinity;
  weights = areas / sum;
  const float depth = weights.x * localA.z + weights.y * localB.z + weights.z * localC.z;
  const float t = depth * ray.inverseZ;
  return t > 0.0 ? t : kInfinity;
}

// The distance to the near side of the sphere, or infinity. From inside, or from the surface inwards, the
// sphere is not seen.
//
// b^2 - a c suffers cancellation for a distant sphere, and r^2 - (distance of the centre from the ray)^2 for
// a huge one; each is used where its terms are the smaller ones. In c, the largest component is paired with
// the radius. Based on: Haines, Guenther and Akenine-Moeller, "Precision Improvements for Ray/Sphere
// Intersection", 2019.
float intersectSphere(Ray ray, vec3 center, float radius) {
  const vec3 f = ray.origin - center;
  const float a = preciseDot(ray.direction, ray.direction);
  const float b = -preciseDot(f, ray.direction);
  const vec3 size = abs(f);
  const float m = maxComponent(size);
  const vec2 others = size.x == m ? size.yz : (size.y == m ? size.xz : size.xy);
  const float c = (m - radius) * (m + radius) + (others.x * others.x + others.y * others.y);
  if (!(b > 0.0 && c > 0.0)) return kInfinity;
  const float radius2 = radius * radius;
  const float b2 = b * b;
  const float huge = a * radius2;
  float discriminant;
  if (b2 < huge) {
    discriminant = b2 - a * c;
  } else {
    const vec3 offset = f + (b / a) * ray.direction;
    discriminant = a * (radius2 - preciseDot(offset, offset));
  }
  if (!(discriminant >= 0.0)) return kInfinity;
  const float t = c / (b + sqrt(discriminant));
  return t > 0.0 ? t : kInfinity;
}

// The distance to the plane, or infinity.
float intersectPlane(Ray ray, vec3 normal, float distance) {
  const float t = (distance - preciseDot(normal, ray.origin)) / preciseDot(normal, ray.direction);
  return t > 0.0 ? t : kInfinity;  // a ray in the plane has 0 / 0, a NaN: a miss; x / 0 is infinite
}

#endif
