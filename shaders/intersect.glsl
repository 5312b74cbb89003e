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

// What a traversal needs of its ray, computed once.
struct RayConstants {
  vec3 inverse;    // of the direction; +-infinity where that is zero
  bvec3 negative;  // for each axis, whether the ray enters a box through its upper side
  uint axis;       // of the direction's largest component, which becomes the ray's z axis
  vec3 shear;      // the direction in its axes, scaled by a power of two so that 1 <= |shear.z| < 2
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

// The ray must have no denormal numbers.
RayConstants rayConstants(Ray ray) {
  RayConstants constants;
  constants.inverse = 1.0 / ray.direction;
  constants.negative = lessThan(constants.inverse, vec3(0.0));
  const vec3 size = abs(ray.direction);
  constants.axis = size.z >= size.x && size.z >= size.y ? 2u : (size.y >= size.x ? 1u : 0u);
  const vec3 direction = permute(ray.direction, constants.axis);
  // 2^-e for |z| = m 2^e, by its exponent bits: e becomes -e.
  const uint exponentBits = floatBitsToUint(direction.z) & 0x7F800000u;
  constants.shear = direction * uintBitsToFloat(0x7F000000u - exponentBits);
  constants.inverseZ = 1.0 / direction.z;
  return constants;
}

// The distances at which the ray enters four boxes, or infinity where it misses one or enters it beyond tMax.
// `near` and `far` are the bounds that it meets first and last on each axis, by the sign of its direction.
//
// With the near and the far bound chosen by the sign of the direction, not by minimum and maximum, 0 *
// infinity (a ray in the plane of a side) is a NaN that every comparison rejects: the axis sets no bound. The
// far distance is widened by two units in the last place, which covers the rounding on all three axes: Ize,
// "Robust BVH Ray Traversal", 2013.
vec4 intersectBoxes(Ray ray, RayConstants constants, vec4 near[3], vec4 far[3], float tMax) {
  vec4 entry = vec4(0.0);
  vec4 exit = vec4(tMax);
  for (int axis = 0; axis < 3; ++axis) {
    const vec4 tNear = (near[axis] - ray.origin[axis]) * constants.inverse[axis];
    const vec4 tFar = (far[axis] - ray.origin[axis]) * constants.inverse[axis];
    entry = mix(entry, tNear, greaterThan(tNear, entry));
    exit = mix(exit, tFar, lessThan(tFar, exit));
  }
  const vec4 paddedExit = exit * 1.00000024;
  return mix(vec4(kInfinity), entry, lessThanEqual(entry, paddedExit));
}

// The distance to the triangle, or infinity; `weights` are the barycentric coordinates of a, b, c.
//
// The triangle is sheared into coordinates in which the ray is the z axis, and the signs of the areas that
// this axis spans with each edge are compared. Two triangles that share an edge compute the same products for
// it, so no ray passes between them.
//
// Based on: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013; without its
// double-precision fallback, which only takes back hits on edges, and multiplying by the shear's z in place
// of dividing by it. So the vertices of a scene in round numbers are sheared exactly, and the ray through a
// pixel's centre hits an edge that it lies on.
float intersectTriangle(Ray ray, RayConstants constants, vec3 a, vec3 b, vec3 c, out vec3 weights) {
  const vec3 localA = permute(a - ray.origin, constants.axis);
  const vec3 localB = permute(b - ray.origin, constants.axis);
  const vec3 localC = permute(c - ray.origin, constants.axis);
  const vec2 shearedA = localA.xy * constants.shear.z - constants.shear.xy * localA.z;
  const vec2 shearedB = localB.xy * constants.shear.z - constants.shear.xy * localB.z;
  const vec2 shearedC = localC.xy * constants.shear.z - constants.shear.xy * localC.z;
  const vec3 areas = vec3(shearedC.x * shearedB.y - shearedC.y * shearedB.x,
                          shearedA.x * shearedC.y - shearedA.y * shearedC.x,
                          shearedB.x * shearedA.y - shearedB.y * shearedA.x);
  weights = vec3(0.0);
  if (any(lessThan(areas, vec3(0.0))) && any(greaterThan(areas, vec3(0.0)))) return kInfinity;
  const float sum = areas.x + areas.y + areas.z;
  if (sum == 0.0) return kInfinity;
  weights = areas / sum;
  const float depth = weights.x * localA.z + weights.y * localB.z + weights.z * localC.z;
  const float t = depth * constants.inverseZ;
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
