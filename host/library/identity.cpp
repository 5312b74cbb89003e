#include "library/identity.hpp"

#include <span>
#include <sstream>

#include "base/errors.hpp"
#include "library/version.hpp"
#include "render/variant.hpp"

namespace lavaray {
namespace {

// Enough digits to tell any two numbers apart.
std::string exactly(double number) {
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

std::string describe(const Rectangle& crop) {
  return std::to_string(crop.x0) + ',' + std::to_string(crop.y0) + " to " + std::to_string(crop.x1) + ',' +
         std::to_string(crop.y1);
}

std::string describe(const SampleRange& range) {
  return std::to_string(range.first) + ':' + std::to_string(range.end);
}

template <typename Value>
std::string checksumOfValues(const std::vector<Value>& values) {
  return checksumOf(std::as_bytes(std::span(values)));
}

void addNumbers(std::vector<double>& all, const glm::dvec3& vector,
                std::initializer_list<double> others = {}) {
  all.insert(all.end(), {vector.x, vector.y, vector.z});
  all.insert(all.end(), others);
}

// Of everything but meshes: numbers, not structs, which have padding.
std::string checksumOfObjects(const Scene& scene) {
  std::vector<double> all;
  const Camera& camera = scene.camera;
  addNumbers(all, camera.position, {camera.fovDegrees, camera.focalLength, camera.aspect});
  for (const Plane& plane : scene.planes) {
    addNumbers(all, plane.normal);
    addNumbers(all, plane.point, {static_cast<double>(plane.object)});
  }
  for (const Sphere& sphere : scene.spheres)
    addNumbers(all, sphere.center, {sphere.radius, static_cast<double>(sphere.object)});
  for (const Triangle& triangle : scene.triangles) {
    for (const glm::dvec3& vertex : triangle.vertices)
      addNumbers(all, vertex, {static_cast<double>(triangle.object)});
  }
  for (const MeshObject& mesh : scene.meshObjects)
    all.insert(all.end(), {static_cast<double>(mesh.mesh), static_cast<double>(mesh.object)});
  for (const Material& material : scene.materials) {
    addNumbers(all, material.ambient);
    addNumbers(all, material.diffuse);
    addNumbers(all, material.specular, {material.shininess});
    addNumbers(all, material.reflectance);
  }
  for (const Light& light : scene.lights) {
    addNumbers(all, light.position);
    addNumbers(all, light.ambient);
    addNumbers(all, light.diffuse);
    addNumbers(all, light.specular, {light.radius});
  }
  return checksumOfValues(all);
}

void addMeshes(const Scene& scene, Identity& identity) {
  const std::filesystem::path folder = scene.file.parent_path();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    if (mesh.file.empty()) {
      identity.emplace_back("mesh " + std::to_string(i), checksumOfValues(mesh.positions) + ' ' +
                                                             checksumOfValues(mesh.normals) + ' ' +
                                                             checksumOfValues(mesh.triangles));
    } else {
      identity.emplace_back("mesh " + mesh.file.lexically_proximate(folder).string(),
                            checksumOfFile(mesh.file));
    }
  }
}

}  // namespace

void describeScene(const v0::Scene::State& state, Identity& identity) {
  if (state.isRead) {
    identity.emplace_back("scene", state.text ? checksumOf(std::as_bytes(std::span(*state.text)))
                                              : checksumOfFile(state.scene.file));
  }
  if (!state.isRead || state.isChanged) identity.emplace_back("objects", checksumOfObjects(state.scene));
  addMeshes(state.scene, identity);
}

Identity describeIdentity(const v0::Scene::State& scene, const RenderSettings& settings) {
  Identity identity = {
      {"lavaray", kVersion},
      {"shader", checksumOf(std::as_bytes(shaderOf(settings, hasFewPrimitives(scene.scene))))}};
  describeScene(scene, identity);
  identity.emplace_back("--width", std::to_string(settings.size.width));
  identity.emplace_back("--height", std::to_string(settings.size.height));
  identity.emplace_back("--max-depth", std::to_string(settings.maxDepth));
  identity.emplace_back("--reflect", exactly(scene.defaults.reflect));
  identity.emplace_back("--light-radius", exactly(scene.defaults.lightRadius));
  if (settings.targetError) {
    identity.emplace_back("--target-error", exactly(*settings.targetError));
    identity.emplace_back("--max-spp", std::to_string(settings.maxSamples));
  } else {
    identity.emplace_back("--spp", std::to_string(settings.samples));
  }
  if (settings.targetError || settings.samples > 1) {
    identity.emplace_back("--seed", std::to_string(settings.seed));
    identity.emplace_back("--sampler", samplerName(settings.sampler));
    identity.emplace_back("--filter", pixelFilterName(settings.filter));
  }
  return identity;
}

void checkSame(const FilmReader& film, const Identity& identity, const RenderSettings& settings) {
  const FilmHeader& header = film.header();
  std::string difference = describeDifference(identity, header.identity);
  const auto add = [&](const std::string& what, const std::string& here, const std::string& there) {
    difference += (difference.empty() ? "" : "; ") + what + ' ' + here + " here and " + there + " there";
  };
  if (!(header.crop == settings.crop)) add("the crop is", describe(settings.crop), describe(header.crop));
  const SampleRange range = settings.range.value_or(SampleRange{0, header.samples});
  if (!(header.range == range)) add("--sample-range is", describe(range), describe(header.range));
  if (difference.empty()) return;
  throw Error(ExitCode::kInput, film.file().string() + " is of another picture: " + difference,
              film.file().string());
}

}  // namespace lavaray
