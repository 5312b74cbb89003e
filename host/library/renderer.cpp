#include <lavaray/renderer.h>

#include <utility>

#include "base/errors.hpp"
#include "library/callbacks.hpp"
#include "library/device_state.hpp"
#include "library/guarded.hpp"
#include "library/render_options.hpp"
#include "library/scene_state.hpp"
#include "library/shader_state.hpp"
#include "render/pixel_values.hpp"

namespace lavaray::v0 {
namespace {

void checkOwnOptions(const RenderOptions& options) {
  const RenderOptions usual;
  const bool isUsual = options.samples == usual.samples && !options.range && !options.targetError &&
                       !options.timeLimitSeconds && options.view == usual.view &&
                       options.filter == usual.filter && options.sampler == usual.sampler &&
                       !options.normalize && !options.countRays && !options.keepsFilm && !options.shader;
  if (isUsual) return;
  throw lavaray::Error(
      ExitCode::kUsage,
      "a shader of one's own makes one value of each pixel: of the options only width, height, crop, "
      "seed and maxDepth are for it");
}

}  // namespace

Picture Renderer::render(const Scene& scene, const RenderOptions& options, const OnProgress& progress) const {
  RenderOptions kept = options;
  kept.keepsPicture = true;
  RenderJob job(device_, scene, kept);
  job.run(progress ? RenderJob::Proceed([&] { return progress(job.shareDone()); }) : RenderJob::Proceed());
  return {job.image(), job.statistics()};
}

Image Renderer::run(const Shader& shader, const Scene& scene, const RenderOptions& options,
                    const OnProgress& progress) const {
  Callbacks callbacks;
  Image image = guarded([&] {
    checkOwnOptions(options);
    RenderSettings settings = planFor(options, scene.state().scene).settings;
    settings.shader = shader.state().spirv;
    settings.view = View::kCost;  // counts tests
    const std::shared_ptr<const GpuScene> flat = flattened(scene.state());
    Image result{settings.crop.width(), settings.crop.height(), {}};
    result.rgb.resize(3 * settings.crop.pixels());
    auto next = result.rgb.begin();
    (void)tracePixels(
        device_.state().open().device, *flat, settings,
        [&](std::span<const gpu::WorkResult> values) {
          for (const gpu::WorkResult& value : values) next = std::copy_n(&value.sum.x, 3, next);
        },
        [&](double share) { return callbacks.call(progress, share); });
    return result;
  });
  callbacks.rethrow();
  return image;
}

}  // namespace lavaray::v0
