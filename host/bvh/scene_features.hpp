#pragma once

#include <cstddef>
#include <cstdint>

#include "scene/scene.hpp"

namespace lavaray {

// What a scene has, as far as the code of a pipeline depends on it. Known before there is a hierarchy.
struct SceneFeatures {
  std::size_t primitiveCount = 0;  // duplicates included
  std::size_t sphereCount = 0;     // of these
  std::uint32_t planeCount = 0;
  std::uint32_t lightCount = 0;
  bool hasFewPrimitives = false;  // see hasFewPrimitives()
  bool hasSpheres = false;
  bool hasTriangles = false;
  bool hasCornerNormals = false;
  bool hasMirrors = false;
  bool hasSphericalLights = false;
  bool operator==(const SceneFeatures&) const = default;
};

SceneFeatures featuresOf(const Scene& scene);

// Whether the scene has at most gpu::kMaxFewPrimitives primitives, so that rays test every one of them.
bool hasFewPrimitives(const Scene& scene);

}  // namespace lavaray
