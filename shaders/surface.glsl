// The point of a hit: its position, how accurate that is, and its normals.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

#include "find_hit.glsl"

struct SurfacePoint {
  uint object;  // that it is on
  vec3 position;
  float error;           // bounds the position's distance from the surface
  vec3 geometricNormal;  // unit length; decides the side on which a secondary ray leaves
  vec3 shadingNormal;    // unit length, on the side that the surface is seen from
};

// Half a unit in the last place of 1, and how many of these a position may be off by, relative to the numbers
// that it is computed from: 4 in the projection below (5 in a sphere's normal and radius), 2 in the host's
// rounding of coordinates and normals, and 1 in adding the offset.
const float kHalfUlp = 5.9604645e-8;
const float kPositionUlps = 8.0;

// The same relative to the extent of a triangle. The faces that meet at a point of a mesh are tested relative
// to that point, and there the coordinates of a distant vertex lose the digits of the point's own.
const float kExtentUlps = 4.0;

// Moves a point near a plane onto it. What remains is the rounding of the distance, not that of t.
SurfacePoint pointOnPlane(vec3 near, vec3 normal, float distance, vec3 direction, uint object) {
  const float offPlane = preciseDot(normal, near) - distance;
  const vec3 position = near - offPlane * normal;
  const float error = kPositionUlps * kHalfUlp * (preciseDot(abs(normal), abs(position)) + abs(distance));
  const vec3 facing = preciseDot(normal, direction) > 0.0 ? -normal : normal;
  return SurfacePoint(object, position, error, facing, facing);
}

SurfacePoint pointOnSphere(vec3 near, Primitive sphere) {
  const vec3 center = sphere.a;
  const float radius = sphere.b.x;
  const vec3 normal = unit(near - center);
  const vec3 position = center + radius * normal;
  const float error = kPositionUlps * kHalfUlp * (preciseDot(abs(normal), abs(center)) + radius);
  return SurfacePoint(sphere.object, position, error, normal, normal);
}

// The interpolated normal, on the side of the face that is seen, so that neither the winding order nor a
// silhouette flips it. Zero where the corner normals cancel.
vec3 interpolatedNormal(uint firstCornerNormal, vec3 weights, vec3 facing) {
  const vec3 normal = unit(weights.x * fetchCornerNormal(firstCornerNormal).normal +
                           weights.y * fetchCornerNormal(firstCornerNormal + 1u).normal +
                           weights.z * fetchCornerNormal(firstCornerNormal + 2u).normal);
  return preciseDot(normal, facing) < 0.0 ? -normal : normal;
}

SurfacePoint pointOnTriangle(vec3 near, uint surface, Primitive primitive, Ray ray) {
  const TrianglePlane plane = fetchTrianglePlane(surface);
  SurfacePoint point = pointOnPlane(near, plane.normal, plane.distance, ray.direction, primitive.object);
  const vec3 extent = max(abs(primitive.b - primitive.a), abs(primitive.c - primitive.a));
  point.error += kExtentUlps * kHalfUlp * maxComponent(extent);
  if (kHasCornerNormals && primitive.kind != kPrimitiveFlatTriangle) {
    // Once more, so that no ray carries its weights through the hierarchy.
    vec3 weights;
    intersectTriangle(withoutDenormals(ray), primitive, weights);
    const vec3 normal = interpolatedNormal(primitive.kind, weights, point.geometricNormal);
    if (normal != vec3(0.0)) point.shadingNormal = normal;
  }
  return point;
}

SurfacePoint surfacePoint(Ray ray, Hit hit) {
  const vec3 near = ray.origin + hit.t * ray.direction;
  if (kPlaneCount > 0u && (hit.surface & kPlaneBit) != 0u) {
    const Plane plane = fetchPlane(hit.surface & ~kPlaneBit);
    return pointOnPlane(near, plane.normal, plane.distance, ray.direction, plane.object);
  }
  const Primitive primitive = fetchPrimitive(hit.surface);
  if (kHasSpheres && (!kHasTriangles || primitive.kind == kPrimitiveSphere)) {
    return pointOnSphere(near, primitive);
  }
  return pointOnTriangle(near, hit.surface, primitive, ray);
}

// The origin of a ray that leaves the point in `direction`: moved off the surface by the error bound, to the
// ray's side, so that no part of the surface is hit at distance zero.
vec3 leave(SurfacePoint point, vec3 direction) {
  const float side = preciseDot(point.geometricNormal, direction) < 0.0 ? -1.0 : 1.0;
  return point.position + (side * point.error) * point.geometricNormal;
}

#endif
