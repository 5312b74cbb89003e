// What the stress tests' probe shaders and their hosts both know; see shaders/interface.h for the rules.
#ifndef LAVARAY_STRESS_PROBES_H
#define LAVARAY_STRESS_PROBES_H

#include "../../device/shaders/probe.h"

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

// A ray that finds a point of a surface; the elevation (in radians, negative below the surface) and azimuth
// of another that leaves this point; and a light, to ask whether the point is in its shadow.
struct SurfaceQuery {
  vec3 origin;
  float elevation;
  vec3 direction;
  float azimuth;
  vec3 light;
  uint skipsItself;  // whether the leaving ray skips the surface that it leaves, as the renderer's rays do
};

// `surface` is kNoSurface, 0xFFFFFFFF, and the rest meaningless where the ray hits nothing.
struct SurfaceAnswer {
  vec3 position;
  float t;
  vec3 geometricNormal;
  uint surface;
  vec3 shadingNormal;
  uint order;
  vec3 departure;   // where the leaving ray starts
  uint hitsItself;  // whether the leaving ray hits the surface that it leaves
  vec3 leaving;     // its direction
  uint blocked;     // whether a surface lies between the point and the light
};

struct ArithmeticQuery {
  float a;
  float b;
  float c;
  uint padding0;
};

// What the device makes of a query's numbers.
struct ArithmeticAnswer {
  float sum;       // a + b
  float product;   // a b
  float quotient;  // a / b
  float fused;     // fma(a, b, c)
  float root;      // of a
  float inverseRoot;
  float power2;     // 2^a
  float minimum;    // of a and b
  float maximum;    // the same
  uint isLess;      // a < b
  uint isNotLess;   // a >= b
  float specular;   // specularPower(a, b): a is 1 - the cosine
  vec3 unitVector;  // unit(a, b, c)
  uint padding0;
};

struct PointPair {
  vec3 a;
  uint padding0;
  vec3 b;
  uint padding1;
};

struct PairAnswer {
  uint blockedFromAToB;
  uint blockedFromBToA;
};

struct SurfaceConstants {
  uint count;
};

struct PathColor {
  vec3 color;
  uint finished;
};

// A picture of pixels of size 1.
struct PathConstants {
  uint width;
  uint height;
  float focalLength;
  uint maxDepth;  // mirror bounces
};

struct CountConstants {
  uint count;
};

#ifdef __cplusplus
}  // namespace lavaray::gpu
#endif
#endif
