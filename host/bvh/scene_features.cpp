#include "bvh/scene_features.hpp"

#include <algorithm>

#include <glm/vector_relational.hpp>

#include "base/vector_math.hpp"
#include "bvh/primitives.hpp"
#include "interface.h"

namespace lavaray {
namespace {

bool hasCornerNormals(const Mesh& mesh) {
  return !mesh.normals.empty() && std::ranges::any_of(mesh.triangles, [](const MeshTriangle& triangle) {
    return triangle.normals[0] != kNoNormal;
  });
}

bool isMirror(const Material& material) {
  return glm::any(glm::greaterThanEqual(toFloat(material.reflectance), glm::vec3(gpu::kMinReflectance)));
}

}  // namespace

SceneFeatures featuresOf(const Scene& scene) {
  SceneFeatures features;
  features.primitiveCount = primitiveCount(scene);
  features.sphereCount = scene.spheres.size();
  features.planeCount = static_cast<std::uint32_t>(scene.planes.size());
  features.lightCount = static_cast<std::uint32_t>(scene.lights.size());
  features.hasFewPrimitives = hasFewPrimitives(scene);
  features.hasSpheres = features.sphereCount > 0;
  features.hasTriangles = features.primitiveCount > features.sphereCount;
  features.hasCornerNormals = std::ranges::any_of(scene.meshObjects, [&](const MeshObject& object) {
    return hasCornerNormals(scene.meshes[object.mesh]);
  });
  features.hasMirrors = std::ranges::any_of(scene.materials, isMirror);
  features.hasSphericalLights =
      std::ranges::any_of(scene.lights, [](const Light& light) { return light.radius > 0.0; });
  return features;
}

bool hasFewPrimitives(const Scene& scene) {
  return primitiveCount(scene) <= gpu::kMaxFewPrimitives;
}

}  // namespace lavaray
