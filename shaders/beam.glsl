// A beam: the rays of a packet as one, for the test against boxes.
//
// Its rays have directions of the same signs. On each axis they lie, at any t >= 0, between the ray from the
// greatest origin that is the fastest upwards and the one from the least origin that is the fastest
// downwards; so a box takes no more arithmetic than for a single ray, and the beam of one ray is that ray.
// Sums, differences, products and quotients are rounded monotonically: the beam enters every box that one of
// its rays, by itself, is found to enter.
#ifndef BEAM_GLSL
#define BEAM_GLSL

#include "intersect.glsl"
#include "scene_data.glsl"

struct Beam {
  bvec3 negative;  // for each axis, whether the rays enter a box through its upper side
  uint axis;       // the main one of them all
  // Of the ray that bounds where boxes are entered, and of the one that bounds where they are left. The
  // inverse is of the direction: +-infinity where that is zero.
  vec3 nearOrigin;
  vec3 nearInverse;
  vec3 farOrigin;
  vec3 farInverse;
};

// For each axis, whether a ray enters a box through its upper side. A zero counts as its sign.
bvec3 entersDownwards(Ray ray) {
  return lessThan(1.0 / ray.direction, vec3(0.0));
}

// How far apart, relative to the distance from the camera, the origins of a beam's rays may be, and how far,
// relative to the longer component, their directions. A wider beam enters too much, and the other lanes of
// its subgroup wait for it; a narrower one leaves rays to another search (tools/bench_speed/traversal.md).
const float kBeamWidth = 0.01;
const float kBeamTurn = 0.1;

// Whether a ray may be in the beam of another one.
bool isAlong(Ray ray, Ray first) {
  const vec3 apart = abs(ray.origin - first.origin);
  const vec3 turn = abs(ray.direction - first.direction);
  return entersDownwards(ray) == entersDownwards(first) &&
         mainAxis(ray.direction) == mainAxis(first.direction) &&
         maxComponent(apart) <= kBeamWidth * maxComponent(abs(first.origin)) &&
         maxComponent(turn) <= kBeamTurn * maxComponent(abs(first.direction));
}

// The beam of those of the rays that are in it; they must have no denormal numbers.
Beam beamOf(Ray rays[kRaysPerLane], bool isIn[kRaysPerLane], Ray first) {
  const bvec3 negative = entersDownwards(first);
  vec3 lowerOrigin = vec3(kInfinity);
  vec3 upperOrigin = vec3(-kInfinity);
  vec3 lowerInverse = vec3(kInfinity);
  vec3 upperInverse = vec3(-kInfinity);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const vec3 inverse = 1.0 / rays[r].direction;
    if (isIn[r]) {
      lowerOrigin = min(lowerOrigin, rays[r].origin);
      upperOrigin = max(upperOrigin, rays[r].origin);
      lowerInverse = min(lowerInverse, inverse);
      upperInverse = max(upperInverse, inverse);
    }
  }
  return Beam(negative, mainAxis(first.direction), mix(upperOrigin, lowerOrigin, negative),
              mix(lowerInverse, upperInverse, negative), mix(lowerOrigin, upperOrigin, negative),
              mix(upperInverse, lowerInverse, negative));
}

// The distances at which the beam enters four boxes, or infinity where it misses one or enters it beyond
// tMax. `near` and `far` are the bounds that it meets first and last on each axis, by the signs of its
// directions.
//
// With the near and the far bound chosen by the sign of the direction, not by minimum and maximum, 0 *
// infinity (a ray in the plane of a side) is a NaN that every comparison rejects: the axis sets no bound. The
// far distance is widened by two units in the last place, which covers the rounding on all three axes: Ize,
// "Robust BVH Ray Traversal", 2013.
vec4 intersectBoxes(Beam beam, vec4 near[3], vec4 far[3], float tMax) {
  vec4 entry = vec4(0.0);
  vec4 exit = vec4(tMax);
  [[unroll]] for (int axis = 0; axis < 3; ++axis) {
    const vec4 tNear = (near[axis] - beam.nearOrigin[axis]) * beam.nearInverse[axis];
    const vec4 tFar = (far[axis] - beam.farOrigin[axis]) * beam.farInverse[axis];
    entry = mix(entry, tNear, greaterThan(tNear, entry));
    exit = mix(exit, tFar, lessThan(tFar, exit));
  }
  const vec4 paddedExit = exit * 1.00000024;
  return mix(vec4(kInfinity), entry, lessThanEqual(entry, paddedExit));
}

#endif
