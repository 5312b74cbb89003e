#pragma once

#include <lavaray/renderer.h>

#include <memory>
#include <optional>
#include <vector>

#include "library/device_state.hpp"
#include "library/render_options.hpp"
#include "library/scene_state.hpp"
#include "render/render.hpp"

namespace lavaray::v0 {

struct RenderJob::State {
  State(const Device& on, const Scene& of, const RenderOptions& with);

  void buildHierarchy();
  void prepare();
  void checkKeepsFilm() const;
  lavaray::Render& begin();  // after these, where they have not been done
  // Passes on those values of a row of settings.crop that part has, as the options say.
  void show(std::span<const float> row, float largest, const RenderJob::TakeRow& take);

  Device device;
  Scene scene;
  RenderOptions options;
  RenderPlan plan;
  std::shared_ptr<const GpuScene> flat;  // once it is built
  Identity identity;                     // where a film is kept
  bool isPrepared = false;
  std::optional<lavaray::Render> render;  // goes first, as it works with those above
  std::vector<float> shown;               // a row of part
};

}  // namespace lavaray::v0
