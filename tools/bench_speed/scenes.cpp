#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <glm/geometric.hpp>

#include "procedural.hpp"
#include "scene/obj_reader.hpp"

namespace lavaray::bench {
namespace {

enum class Source { kFile, kBumpyBall, kSphereCloud };

struct Recipe {
  std::string_view name;
  Source source;
  std::string_view file;
  std::size_t count;
  bool isQuick;
};

constexpr std::array kRecipes{
    Recipe{"bunny", Source::kFile, "stanford-bunny.obj", 0, true},
    Recipe{"nefertiti", Source::kFile, "nefertiti.obj", 0, false},
    Recipe{"beast", Source::kFile, "beast.obj", 0, false},
    Recipe{"10k", Source::kBumpyBall, "", 10000, true},
    Recipe{"100k", Source::kBumpyBall, "", 100000, true},
    Recipe{"1M", Source::kBumpyBall, "", 1000000, false},
    Recipe{"2.5M", Source::kBumpyBall, "", 2500000, false},
    Recipe{"1k-spheres", Source::kSphereCloud, "", 1000, true},
    Recipe{"10k-spheres", Source::kSphereCloud, "", 10000, false},
    Recipe{"100k-spheres", Source::kSphereCloud, "", 100000, false},
    Recipe{"1M-spheres", Source::kSphereCloud, "", 1000000, false},
};

struct Extent {
  glm::dvec3 lower{INFINITY};
  glm::dvec3 upper{-INFINITY};
  void extend(const glm::dvec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
};

Extent extentOf(const Scene& scene) {
  Extent extent;
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::dvec3& position : mesh.positions) extent.extend(position);
  }
  for (const Sphere& sphere : scene.spheres) {
    extent.extend(sphere.center - sphere.radius);
    extent.extend(sphere.center + sphere.radius);
  }
  return extent;
}

// The camera sees the front of the extent from edge to edge. One light is to the upper left, a weaker one to
// the right, both on the camera's side.
void addCameraAndLights(Scene& scene, const ImageSize& size) {
  const Extent extent = extentOf(scene);
  const glm::dvec3 center = 0.5 * (extent.lower + extent.upper);
  const glm::dvec3 half = 0.5 * (extent.upper - extent.lower);
  const double tangent = std::tan(std::numbers::pi / 8.0);
  const double aspect = static_cast<double>(size.width) / size.height;
  scene.camera.fovDegrees = 45.0;
  // Half a pixel more than asked for, as the size is truncated.
  scene.camera.focalLength = (size.height + 0.5) / (2.0 * tangent);
  scene.camera.aspect = (size.width + 0.5) / size.height;
  const double distance = 1.02 * std::max(half.y, half.x / aspect) / tangent;
  scene.camera.position = center + glm::dvec3(0.0, 0.0, half.z + distance);

  const double radius = glm::length(half);
  Light light;
  light.position = center + radius * glm::dvec3(-2.0, 3.0, 2.5);
  light.diffuse = glm::dvec3(0.5);
  light.specular = glm::dvec3(0.2);
  scene.lights.push_back(light);
  light.position = center + radius * glm::dvec3(3.0, 1.0, 1.5);
  light.diffuse = glm::dvec3(0.25);
  scene.lights.push_back(light);
}

Material material() {
  Material result;
  result.ambient = glm::dvec3(0.05);
  result.diffuse = glm::dvec3(0.8, 0.7, 0.6);
  result.specular = glm::dvec3(0.3);
  result.shininess = 20.0;
  return result;
}

}  // namespace

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const Recipe& recipe : kRecipes) names.emplace_back(recipe.name);
  return names;
}

std::vector<std::string> quickSceneNames() {
  std::vector<std::string> names;
  for (const Recipe& recipe : kRecipes) {
    if (recipe.isQuick) names.emplace_back(recipe.name);
  }
  return names;
}

std::optional<BenchScene> makeScene(const std::string& name, const std::filesystem::path& meshFolder,
                                    const ImageSize& size) {
  const auto* recipe =
      std::find_if(kRecipes.begin(), kRecipes.end(), [&](const auto& r) { return r.name == name; });
  BenchScene result;
  result.name = name;
  Scene& scene = result.scene;
  if (recipe->source == Source::kSphereCloud) {
    result.isSpheres = true;
    result.what = "spheres in a grid, shaken";
    scene.spheres = sphereCloud(recipe->count);
    result.primitives = scene.spheres.size();
  } else {
    result.what = recipe->source == Source::kFile ? std::string(recipe->file) : "bumpy ball";
    const std::filesystem::path file = meshFolder / recipe->file;
    if (recipe->source == Source::kFile && !std::filesystem::exists(file)) return std::nullopt;
    scene.meshes.push_back(recipe->source == Source::kFile ? readObj(file) : bumpyBall(recipe->count));
    scene.meshObjects.push_back({0, 0});
    result.primitives = scene.meshes[0].triangles.size();
  }
  // Each sphere is an object of its own, a mesh is a single one.
  scene.materials.resize(std::max<std::size_t>(1, scene.spheres.size()), material());
  addCameraAndLights(scene, size);
  return result;
}

}  // namespace lavaray::bench
