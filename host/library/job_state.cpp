#include "library/job_state.hpp"

#include <algorithm>

#include "base/available_memory.hpp"
#include "base/errors.hpp"
#include "image/false_color.hpp"
#include "library/identity.hpp"
#include "library/preparation.hpp"
#include "render/preparation.hpp"

namespace lavaray {
namespace {

// Before the first ray: later, all that was rendered would be lost.
void checkMemory(const RenderSettings& settings, bool canBeCropped) {
  const std::uint64_t needed = hostBytes(settings);
  const AvailableMemory room = availableMemory();
  if (needed <= room.bytes) return;
  const Rectangle& part = settings.crop;
  throw Error(ExitCode::kMemory, "there is not enough memory: a picture of " + std::to_string(part.width()) +
                                     " x " + std::to_string(part.height()) + " pixels needs " +
                                     inGigabytes(needed) + ", and " + room.limit + ' ' +
                                     inGigabytes(room.bytes) + "; a smaller --width or --height needs less" +
                                     (canBeCropped ? ", or parts by --crop" : "") +
                                     (takesCenters(settings) ? "" : ", or one sample per pixel"));
}

// Prepares the pipeline while the scene's first hierarchy is built: later ones are built with that of the
// first at hand. Null where that is not worth it.
std::unique_ptr<Preparation> beginPreparation(const v0::Device::State& device, v0::Scene::State& scene,
                                              RenderSettings& settings) {
  const SceneFeatures features = featuresOf(scene.scene);
  if (isFlattened(scene) || !isWorthPreparing(features, settings)) return nullptr;
  settings.minStackSize = expectedStackSize(features.primitiveCount);
  return std::make_unique<Preparation>(device, features, settings);
}

}  // namespace

namespace v0 {

RenderJob::State::State(const Device& on, const Scene& of, const RenderOptions& with)
    : device(on), scene(of), options(with), plan(planFor(options, scene.state().scene)) {}

void RenderJob::State::buildHierarchy() {
  if (flat) return;
  Scene::State& state = scene.state();
  const std::unique_ptr<Preparation> preparation = beginPreparation(device.state(), state, plan.settings);
  flat = flattened(state);
  const bool hasBegun = preparation && preparation->stop();
  const std::lock_guard lock(state.mutex);
  if (hasBegun) state.minStackSize = plan.settings.minStackSize;
  plan.settings.minStackSize = state.minStackSize;
}

void RenderJob::State::prepare() {
  buildHierarchy();
  if (isPrepared) return;
  OpenDevice& open = device.state().open();
  // Now: by the time that a film is written the files may have changed.
  if (options.keepsFilm) identity = describeIdentity(scene.state(), plan.settings);
  checkMemory(plan.settings, !needsWhole(options));
  open.tuning.prepareFor(flat->lightCount, plan.settings);
  plan.settings.tuning = open.tuning.get();
  isPrepared = true;
}

void RenderJob::State::checkKeepsFilm() const {
  if (options.keepsFilm) return;
  throw lavaray::Error(ExitCode::kUsage, "a film is of a render with RenderOptions::keepsFilm");
}

lavaray::Render& RenderJob::State::begin() {
  prepare();
  if (!render) render.emplace(device.state().open().device, *flat, plan.settings);
  return *render;
}

void RenderJob::State::show(std::span<const float> row, float largest, const RenderJob::TakeRow& take) {
  const auto first = 3 * static_cast<std::size_t>(plan.part.x0 - plan.settings.crop.x0);
  shown.assign(
      row.begin() + static_cast<std::ptrdiff_t>(first),
      row.begin() + static_cast<std::ptrdiff_t>(first + 3 * static_cast<std::size_t>(plan.part.width())));
  // Divided, so that the largest is exactly 1.
  if (largest > 0.0F) {
    for (float& value : shown) value /= largest;
  }
  if (options.falseColors && options.view == View::kCost) lavaray::applyFalseColors(shown);
  take(shown.data());
}

}  // namespace v0
}  // namespace lavaray
