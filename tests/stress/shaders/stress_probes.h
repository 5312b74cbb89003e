// What the stress tests' probe shaders and their hosts both know; see shaders/interface.h for the rules.
#ifndef LAVARAY_STRESS_PROBES_H
#define LAVARAY_STRESS_PROBES_H

#include "../../shaders/probe.h"

#ifdef __cplusplus
namespace lavaray::gpu {
#endif

// Values of ShapeQuery::shape, and what its vectors are.
const uint kShapeBox = 0u;       // a: lower, b: upper corner
const uint kShapeTriangle = 1u;  // a, b, c: vertices
const uint kShapeSphere = 2u;    // a: centre, b.x: radius
const uint kShapePlane = 3u;     // a: normal, b.x: distance

struct ShapeQuery {
  vec3 origin;
  float tMax;  // of a box only
  vec3 direction;
  uint shape;
  vec3 a;
  uint padding0;
  vec3 b;
  uint padding1;
  vec3 c;
  uint padding2;
};

struct CountConstants {
  uint count;
};

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif
#endif
