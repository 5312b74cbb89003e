// What is tested against boxes in place of the rays that search the hierarchy together.
//
// Such rays are alike: their directions have the same signs and the same main axis. On each axis they lie, at
// any t >= 0, between the ray from the greatest origin that is the fastest upwards and the one from the least
// origin that is the fastest downwards. These two are a beam. A box takes no more arithmetic for a beam than
// for a single ray, and the beam of one ray is that ray. Sums, differences, products and quotients are
// rounded monotonically: the beam enters every box that one of its rays, by itself, is found to enter.
//
// Searches for the nearest hit are one beam. Shadow rays are a beam each, on one list of nodes all the same:
// they leave points at different depths, between which a common beam would enter far too much, and they need
// neither the distances of boxes nor their order.
#ifndef BEAM_GLSL
#define BEAM_GLSL

#include "intersect.glsl"
#include "scene_data.glsl"

struct Beam {
  // Of the ray that bounds where boxes are entered, and of the one that bounds where they are left. The
  // inverse is of the direction: +-infinity where that is zero.
  vec3 nearOrigin;
  vec3 nearInverse;
  vec3 farOrigin;
  vec3 farInverse;
};

// Rays that are alike.
struct Approach {
  bvec3 negative;            // for each axis, whether they enter a box through its upper side
  uint axis;                 // their main one
  Beam beams[kRaysPerLane];  // for any hit one for each ray, else only the first
};

// For each axis, whether a ray enters a box through its upper side. A zero counts as its sign.
bvec3 entersDownwards(Ray ray) {
  return lessThan(1.0 / ray.direction, vec3(0.0));
}

bool isAlike(Ray ray, Ray other) {
  return entersDownwards(ray) == entersDownwards(other) &&
         mainAxis(ray.direction) == mainAxis(other.direction);
}

// How far apart, relative to the distance from the camera, the origins of a beam's rays may be, and how far,
// relative to the longer component, their directions. A wider beam enters too much, and the other lanes of
// its subgroup wait for it; a narrower one leaves rays to another search (tools/bench_speed/traversal.md).
const float kBeamWidth = 0.003;
const float kBeamTurn = 0.03;

bool isNear(Ray ray, Ray other) {
  const vec3 apart = abs(ray.origin - other.origin);
  const vec3 turn = abs(ray.direction - other.direction);
  return maxComponent(apart) <= kBeamWidth * maxComponent(abs(other.origin)) &&
         maxComponent(turn) <= kBeamTurn * maxComponent(abs(other.direction));
}

// Whether a ray may search together with another one.
bool isAlong(const bool anyHit, Ray ray, Ray first) {
  return isAlike(ray, first) && (anyHit || isNear(ray, first));
}

// Of those of the rays that are in it; they must have no denormal numbers.
Approach approachOf(const bool anyHit, Ray rays[kRaysPerLane], bool isIn[kRaysPerLane], Ray first) {
  Approach result;
  result.negative = entersDownwards(first);
  result.axis = mainAxis(first.direction);
  vec3 lowerOrigin = vec3(kInfinity);
  vec3 upperOrigin = vec3(-kInfinity);
  vec3 lowerInverse = vec3(kInfinity);
  vec3 upperInverse = vec3(-kInfinity);
  [[unroll]] for (uint r = 0u; r < kRaysPerLane; ++r) {
    const vec3 origin = rays[r].origin;
    const vec3 inverse = 1.0 / rays[r].direction;
    if (anyHit) {
      result.beams[r] = Beam(origin, inverse, origin, inverse);
    } else if (isIn[r]) {
      lowerOrigin = min(lowerOrigin, origin);
      upperOrigin = max(upperOrigin, origin);
      lowerInverse = min(lowerInverse, inverse);
      upperInverse = max(upperInverse, inverse);
    }
  }
  if (!anyHit) {
    const bvec3 negative = result.negative;
    result.beams[0] =
        Beam(mix(upperOrigin, lowerOrigin, negative), mix(lowerInverse, upperInverse, negative),
             mix(lowerOrigin, upperOrigin, negative), mix(upperInverse, lowerInverse, negative));
  }
  return result;
}

// Which of four boxes the beam enters up to tMax, and the distances at which it does. `near` and `far` are
// the bounds that it meets first and last on each axis, by the signs of its directions.
//
// With the near and the far bound chosen by the sign of the direction, not by minimum and maximum, 0 *
// infinity (a ray in the plane of a side) is a NaN that every comparison rejects: the axis sets no bound. The
// far distance is widened by two units in the last place, which covers the rounding on all three axes: Ize,
// "Robust BVH Ray Traversal", 2013.
bvec4 entersBoxes(Beam beam, vec4 near[3], vec4 far[3], float tMax, out vec4 entry) {
  entry = vec4(0.0);
  vec4 exit = vec4(tMax);
  [[unroll]] for (int axis = 0; axis < 3; ++axis) {
    const vec4 tNear = (near[axis] - beam.nearOrigin[axis]) * beam.nearInverse[axis];
    const vec4 tFar = (far[axis] - beam.farOrigin[axis]) * beam.farInverse[axis];
    entry = mix(entry, tNear, greaterThan(tNear, entry));
    exit = mix(exit, tFar, lessThan(tFar, exit));
  }
  const vec4 paddedExit = exit * 1.00000024;
  return lessThanEqual(entry, paddedExit);
}

#endif
