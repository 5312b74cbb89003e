#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "unit/oracle_scenes.hpp"

namespace lavaray {

inline constexpr double kPi = std::numbers::pi;

// At the origin, 101 x 101 pixels, the middle one looking along -z.
inline Scene sceneWithView(double fovDegrees) {
  Scene scene;
  scene.camera = {glm::dvec3(0.0), fovDegrees, kFocalLength / std::tan(fovDegrees * kPi / 360.0), 1.0};
  return scene;
}

inline Material glow(const glm::dvec3& color) {
  Material material;
  material.ambient = color;
  return material;
}

inline oracle::Options sampled(int samples, std::uint64_t seed = 1) {
  oracle::Options options;
  options.samples = samples;
  options.seed = seed;
  return options;
}

}  // namespace lavaray
