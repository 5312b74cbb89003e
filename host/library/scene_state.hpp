#pragma once

#include <lavaray/scene.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "bvh/gpu_scene.hpp"
#include "film/film.hpp"
#include "scene/scene.hpp"

namespace lavaray::v0 {

struct Scene::State {
  lavaray::Scene scene;
  Defaults defaults;
  Files files;
  std::set<std::filesystem::path> changed;  // those of them that have not been read successfully since
  std::optional<std::string> text;          // that it was read from; empty is scene.file
  bool isRead = false;                      // from one of both
  bool isChanged = false;                   // since

  std::mutex mutex;                      // of the following
  std::shared_ptr<const GpuScene> flat;  // once it is asked for
  std::shared_ptr<State> former;         // has one that may serve again
  std::uint32_t minStackSize = 0;        // of the pipeline that was prepared for it
};

}  // namespace lavaray::v0

namespace lavaray {

// The scene's arrays for the device, made the first time. Any thread may call it.
std::shared_ptr<const GpuScene> flattened(v0::Scene::State& state);
bool isFlattened(v0::Scene::State& state);  // this scene or a former one

// Checksums of all that the scene is made of.
void describeScene(const v0::Scene::State& state, Identity& identity);

// Gives the defaults to materials and lights that state none.
void applyDefaults(const v0::Defaults& defaults, Scene& scene);

}  // namespace lavaray
