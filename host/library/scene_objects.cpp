// What is added to a scene in place of being read.
#include <cmath>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/limits.hpp"
#include "base/number_text.hpp"
#include "library/guarded.hpp"
#include "library/mesh_arrays.hpp"
#include "library/scene_state.hpp"
#include "scene/camera.hpp"
#include "scene/triangulate.hpp"

namespace lavaray {
namespace {

using v0::Vec3;

glm::dvec3 vector(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

[[noreturn]] void fail(const std::string& what, double value, const std::string& allowed) {
  throw Error(ExitCode::kInput, what + " is " + numberText(value) + ", allowed is " + allowed);
}

double number(const std::string& what, double value) {
  if (!(std::abs(value) <= kMaxMagnitude))
    fail(what, value, "a number within +-" + numberText(kMaxMagnitude));
  return value;
}

double notNegative(const std::string& what, double value) {
  if (number(what, value) < 0.0) fail(what, value, "0 or more");
  return value;
}

double positive(const std::string& what, double value) {
  if (number(what, value) <= 0.0) fail(what, value, "more than 0");
  return value;
}

glm::dvec3 point(const std::string& what, const Vec3& value) {
  for (const double x : value) number("a number of " + what, x);
  return vector(value);
}

glm::dvec3 color(const std::string& what, const Vec3& value) {
  for (const double x : value) notNegative("a number of " + what, x);
  return vector(value);
}

Material material(const std::string& of, const v0::Material& given) {
  Material material;
  material.ambient = color("the ambient colour of " + of, given.ambient);
  material.diffuse = color("the diffuse colour of " + of, given.diffuse);
  material.specular = color("the specular colour of " + of, given.specular);
  material.shininess = notNegative("the shininess of " + of, given.shininess);
  material.statesReflectance = given.reflectance.has_value();
  if (given.reflectance) material.reflectance = color("the reflectance of " + of, *given.reflectance);
  return material;
}

Camera camera(const v0::Camera& given) {
  Camera camera;
  camera.position = point("the camera's position", given.position);
  camera.fovDegrees = positive("the camera's field of view", given.fovDegrees);
  if (camera.fovDegrees >= 180.0) fail("the camera's field of view", camera.fovDegrees, "less than 180");
  camera.focalLength = positive("the camera's focal length", given.focalLength);
  camera.aspect = positive("the camera's aspect ratio", given.aspect);
  if (imageSize(camera)) return camera;
  throw Error(ExitCode::kInput,
              "the camera's field of view, focal length and aspect ratio give no image, allowed are 1 to " +
                  std::to_string(kMaxImageSide) + " pixels on each side");
}

// Adds the material, and returns the object's number.
std::uint32_t addMaterial(v0::Scene::State& state, Material material) {
  if (!material.statesReflectance) material.reflectance = state.defaults.reflect * material.specular;
  state.scene.materials.push_back(material);
  return static_cast<std::uint32_t>(state.scene.materials.size() - 1);
}

}  // namespace

namespace v0 {

Scene::Scene()
    : state_(guarded([] {
        auto state = std::make_shared<State>();
        state->scene.file = "the scene";
        state->scene.camera = lavaray::camera(Camera());
        return state;
      })) {}

// Checked before: a change that is refused changes nothing.
Scene::State& Scene::change() {
  State& state = own();
  state.flat.reset();
  state.former.reset();
  state.minStackSize = 0;
  state.isChanged = true;
  return state;
}

void Scene::setCamera(const Camera& given) {
  guarded([&] {
    const lavaray::Camera checked = lavaray::camera(given);
    change().scene.camera = checked;
  });
}

Camera Scene::camera() const {
  const lavaray::Camera& camera = state_->scene.camera;
  return {{camera.position.x, camera.position.y, camera.position.z},
          camera.fovDegrees,
          camera.focalLength,
          camera.aspect};
}

void Scene::add(const Plane& plane) {
  guarded([&] {
    lavaray::Plane added{point("a plane's normal", plane.normal), point("a plane's point", plane.point), 0};
    if (added.normal == glm::dvec3(0.0))
      throw lavaray::Error(ExitCode::kInput, "a plane's normal is 0 0 0, allowed is any other vector");
    const lavaray::Material checked = material("a plane", plane.material);
    added.object = addMaterial(change(), checked);
    state_->scene.planes.push_back(added);
  });
}

void Scene::add(const Sphere& sphere) {
  guarded([&] {
    lavaray::Sphere added{point("a sphere's centre", sphere.center),
                          positive("a sphere's radius", sphere.radius), 0};
    const lavaray::Material checked = material("a sphere", sphere.material);
    added.object = addMaterial(change(), checked);
    state_->scene.spheres.push_back(added);
  });
}

void Scene::add(const Triangle& triangle) {
  guarded([&] {
    lavaray::Triangle added{};
    for (std::size_t i = 0; i < 3; ++i)
      added.vertices[i] = point("a triangle's vertex", triangle.vertices[i]);
    if (!hasArea(added.vertices[0], added.vertices[1], added.vertices[2])) {
      throw lavaray::Error(ExitCode::kInput,
                           "a triangle without area, allowed are three corners that are not on a line");
    }
    const lavaray::Material checked = material("a triangle", triangle.material);
    added.object = addMaterial(change(), checked);
    state_->scene.triangles.push_back(added);
  });
}

void Scene::add(const Mesh& mesh) {
  guarded([&] {
    lavaray::Mesh added = meshOf(mesh);
    const lavaray::Material checked = material("a mesh", mesh.material);
    State& state = change();
    const std::uint32_t object = addMaterial(state, checked);
    state.scene.warnings.insert(state.scene.warnings.end(), added.warnings.begin(), added.warnings.end());
    state.scene.meshObjects.push_back({state.scene.meshes.size(), object});
    state.scene.meshes.push_back(std::move(added));
  });
}

void Scene::add(const Light& light) {
  guarded([&] {
    lavaray::Light added;
    added.position = point("a light's position", light.position);
    added.ambient = color("a light's ambient colour", light.ambient);
    added.diffuse = color("a light's diffuse colour", light.diffuse);
    added.specular = color("a light's specular colour", light.specular);
    added.statesRadius = light.radius.has_value();
    added.radius = notNegative("a light's radius", light.radius.value_or(state_->defaults.lightRadius));
    change().scene.lights.push_back(added);
  });
}

void Scene::setDefaults(const Defaults& defaults) {
  guarded([&] {
    notNegative("the default reflectance", defaults.reflect);
    notNegative("the lights' default radius", defaults.lightRadius);
    const bool wasChanged = state_->isChanged;
    State& state = change();
    state.isChanged = wasChanged;  // an identity has the defaults anyway
    state.defaults = defaults;
    applyDefaults(defaults, state.scene);
  });
}

}  // namespace v0
}  // namespace lavaray
