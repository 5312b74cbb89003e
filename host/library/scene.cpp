#include <algorithm>
#include <utility>

#include "base/file_claims.hpp"
#include "base/parallel.hpp"
#include "bvh/flatten.hpp"
#include "library/guarded.hpp"
#include "library/scene_state.hpp"
#include "scene/camera.hpp"
#include "scene/scene_reader.hpp"

namespace lavaray {
namespace {

using State = v0::Scene::State;
using Files = v0::Scene::Files;

// Reads a scene and lists its files, of which it takes the meshes of `known` that have not changed.
class Reading {
 public:
  Reading(State& state, const State* known) : state_(state), known_(known) {}

  void read(const std::filesystem::path& file) {
    const MeshReader reader = [this](const std::filesystem::path& mesh) { return readMesh(mesh); };
    if (!state_.text) state_.files.push_back(file);
    state_.scene = state_.text ? parseScene(*state_.text, file, reader) : readScene(file, reader);
    state_.isRead = true;
    applyDefaults(state_.defaults, state_.scene);
  }

 private:
  Mesh readMesh(const std::filesystem::path& file) {
    state_.files.push_back(file);
    noteRead(file, "the mesh");
    if (known_ != nullptr && !known_->changed.contains(file)) {
      const auto mesh = std::ranges::find(known_->scene.meshes, file, &Mesh::file);
      if (mesh != known_->scene.meshes.end()) return *mesh;
    }
    return readObj(file);
  }

  State& state_;
  const State* known_;
};

}  // namespace

std::shared_ptr<const GpuScene> flattened(State& state) {
  const std::lock_guard lock(state.mutex);
  if (state.flat) return state.flat;
  if (state.former && sameGeometry(state.scene, state.former->scene)) {
    // Arrays of a million triangles are copied only while another render reads them.
    const bool isOurs = state.former.use_count() == 1 && state.former->flat.use_count() == 1;
    auto flat = isOurs ? std::const_pointer_cast<GpuScene>(state.former->flat)
                       : std::make_shared<GpuScene>(*state.former->flat);
    flattenShading(state.scene, *flat);
    state.flat = std::move(flat);
  } else {
    state.flat = std::make_shared<GpuScene>(flatten(state.scene, hardwareThreads()));
  }
  state.former.reset();
  return state.flat;
}

bool isFlattened(State& state) {
  const std::lock_guard lock(state.mutex);
  return state.flat || state.former;
}

void applyDefaults(const v0::Defaults& defaults, Scene& scene) {
  for (Material& material : scene.materials) {
    if (!material.statesReflectance) material.reflectance = defaults.reflect * material.specular;
  }
  for (Light& light : scene.lights) {
    if (!light.statesRadius) light.radius = defaults.lightRadius;
  }
}

namespace v0 {

Scene::Scene(std::shared_ptr<State> state) : state_(std::move(state)) {}
Scene::~Scene() = default;
Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Scene Scene::read(const std::filesystem::path& file, const Defaults& defaults, Files* tried) {
  return guarded([&] {
    auto state = std::make_shared<State>();
    state->defaults = defaults;
    try {
      Reading(*state, nullptr).read(file);
    } catch (...) {
      if (tried != nullptr) *tried = state->files;
      throw;
    }
    return Scene(std::move(state));
  });
}

Scene::Files Scene::filesOf(const std::filesystem::path& file) {
  return guarded([&] {
    Files files{file};
    (void)readScene(file, [&](const std::filesystem::path& mesh) {
      files.push_back(mesh);
      return lavaray::Mesh{};
    });
    return files;
  });
}

Scene Scene::parse(std::string_view text, const std::filesystem::path& file, const Defaults& defaults) {
  return guarded([&] {
    auto state = std::make_shared<State>();
    state->defaults = defaults;
    state->text = text;
    Reading(*state, nullptr).read(file);
    return Scene(std::move(state));
  });
}

bool Scene::reread(const Files& changed) {
  return guarded([&] {
    if (std::ranges::find_first_of(changed, state_->files) == changed.end()) return false;
    State& old = own();
    old.changed.insert(changed.begin(), changed.end());
    auto state = std::make_shared<State>();
    state->defaults = old.defaults;
    state->text = old.text;
    try {
      Reading(*state, &old).read(old.scene.file);
    } catch (...) {
      old.files = state->files;
      throw;
    }
    for (const std::filesystem::path& file : old.files) {
      // Files that only the former scene named may be written again.
      if (std::ranges::find(state->files, file) == state->files.end()) forgetRead(file);
    }
    state->former = old.flat ? state_ : old.former;
    state->minStackSize = old.minStackSize;
    state_ = std::move(state);
    return true;
  });
}

// Before a change: the state that belongs to this scene alone.
Scene::State& Scene::own() {
  if (state_.use_count() == 1) return *state_;
  auto copy = std::make_shared<State>();
  copy->scene = state_->scene;
  copy->defaults = state_->defaults;
  copy->files = state_->files;
  copy->changed = state_->changed;
  copy->text = state_->text;
  copy->isRead = state_->isRead;
  copy->isChanged = state_->isChanged;
  const std::lock_guard lock(state_->mutex);
  copy->flat = state_->flat;
  copy->former = state_->former;
  copy->minStackSize = state_->minStackSize;
  state_ = std::move(copy);
  return *state_;
}

SceneSummary Scene::summary() const {
  return guarded([&] {
    const lavaray::Scene& scene = state_->scene;
    SceneSummary summary;
    summary.file = scene.file;
    summary.image = imageSize(scene.camera).value();
    summary.planes = scene.planes.size();
    summary.spheres = scene.spheres.size();
    summary.triangles = scene.triangles.size();
    summary.meshes = scene.meshObjects.size();
    summary.lights = scene.lights.size();
    summary.sphericalLights = static_cast<std::size_t>(
        std::ranges::count_if(scene.lights, [](const lavaray::Light& light) { return light.radius > 0.0; }));
    for (const MeshObject& object : scene.meshObjects)
      summary.meshTriangles += scene.meshes[object.mesh].triangles.size();
    for (const lavaray::Mesh& mesh : scene.meshes) {
      summary.meshFiles.push_back({mesh.file, mesh.triangles.size(), mesh.positions.size(),
                                   mesh.normals.size(), mesh.degenerateTriangles});
    }
    return summary;
  });
}

const std::vector<std::string>& Scene::warnings() const {
  return state_->scene.warnings;
}

const Scene::Files& Scene::files() const {
  return state_->files;
}

}  // namespace v0
}  // namespace lavaray
