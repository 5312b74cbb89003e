// The points that rays find, and the rays that leave them, by the renderer's own functions.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "light.glsl"
#include "single_ray.glsl"
#include "stress_probes.h"

layout(local_size_x = kWorkGroupSize) in;
layout(std430, set = 0, binding = kBindingProbeIn) readonly buffer Queries {
  SurfaceQuery queries[];
};
layout(std430, set = 0, binding = kBindingProbeOut) buffer Answers {
  SurfaceAnswer answers[];
};
layout(push_constant) uniform PushConstants {
  SurfaceConstants constants;
};

vec3 leavingDirection(vec3 normal, float elevation, float azimuth) {
  vec3 x;
  vec3 y;
  orthonormalBasis(normal, x, y);
  return sin(elevation) * normal + cos(elevation) * (cos(azimuth) * x + sin(azimuth) * y);
}

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= constants.count) return;
  const SurfaceQuery query = queries[index];
  const Ray ray = Ray(query.origin, query.direction);
  Hit hit = missUpTo(kInfinity);
  findHit(false, ray, kNoSurface, hit);
  SurfaceAnswer answer;
  answer.surface = hit.surface;
  if (hit.surface != kNoSurface) {
    const SurfacePoint point = surfacePoint(ray, hit);
    answer.position = point.position;
    answer.t = hit.t;
    answer.geometricNormal = point.geometricNormal;
    answer.shadingNormal = point.shadingNormal;
    answer.order = hit.order;
    const vec3 direction = leavingDirection(point.geometricNormal, query.elevation, query.azimuth);
    const Ray leaving = Ray(leave(point, direction), direction);
    answer.departure = leaving.origin;
    answer.leaving = leaving.direction;
    Hit next = missUpTo(kInfinity);
    const uint skipped = query.skipsItself != 0u ? hit.surface : kNoSurface;
    findHit(false, leaving, skipped, next);
    answer.hitsItself = next.surface == hit.surface ? 1u : 0u;
    answer.blocked = isInShadow(point, hit.surface, query.light) ? 1u : 0u;
  }
  answers[index] = answer;
}
