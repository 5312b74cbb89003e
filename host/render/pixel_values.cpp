#include "render/pixel_values.hpp"

#include "render/tracer.hpp"

namespace lavaray {

bool tracePixels(vulkan::Device& device, const GpuScene& scene, RenderSettings settings,
                 const std::function<void(std::span<const gpu::WorkResult>)>& take,
                 const std::function<bool(double)>& proceed) {
  settings.samples = 1;
  settings.range.reset();
  settings.targetError.reset();
  settings.countRays = false;
  const std::uint64_t pixels = settings.crop.pixels();
  Tracer tracer(device, scene, settings, settings.crop, pixels);
  std::uint64_t done = 0;
  return tracer.run(
      uniformPass(pixels, {0, 1}), 0,
      [&](std::uint64_t /*first*/, std::span<const gpu::WorkResult> results) {
        take(results);
        done += results.size();
      },
      [&] { return !proceed(static_cast<double>(done) / static_cast<double>(pixels)); });
}

}  // namespace lavaray
