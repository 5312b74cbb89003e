#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "bvh/flatten.hpp"
#include "render/settings.hpp"
#include "render/tile_starts.hpp"
#include "vulkan/compute.hpp"

namespace lavaray {

struct TraceCounts {
  std::uint64_t dispatches = 0;
  std::uint64_t samples = 0;         // camera rays
  std::uint64_t skippedSamples = 0;  // through tiles of the image in which there is nothing
  // These are counted where the settings ask for it.
  std::uint64_t shadowRays = 0;
  std::uint64_t skippedShadowRays = 0;  // their light would add nothing, or nothing that shows
  std::uint64_t mirrorRays = 0;
};

// The SPIR-V that a render with these settings runs for a scene that has few primitives, or more.
std::span<const std::uint32_t> shaderOf(const RenderSettings& settings, bool hasFewPrimitives);

// A scene on a device, with the pipeline for what the scene has: it takes samples of pixels.
class Tracer {
 public:
  // `items` is how many a run has about; buffers are no larger than that asks for.
  Tracer(vulkan::Device& device, const GpuScene& scene, const Camera& camera, const RenderSettings& settings,
         std::uint64_t items);

  // Fills in, or takes the results of, work items that follow one another from number `first` on.
  using MakeItems = std::function<void(std::uint64_t first, std::span<gpu::WorkItem> items)>;
  using TakeResults = std::function<void(std::uint64_t first, std::span<const gpu::WorkResult> results)>;
  using Stop = std::function<bool()>;

  // Does the work items first .. end - 1, in this order and in pieces of about a tenth of a second, for each
  // of which it calls makeItems and takeResults. Looks at `stop` before each piece and returns false if it
  // was stopped. With the sampling in the pixel's centre, item i is pixel i, and makeItems is not called.
  // Throws Error(kDevice) where the device fails or cannot finish a ray.
  bool run(std::uint64_t first, std::uint64_t end, const MakeItems& makeItems, const TakeResults& takeResults,
           const Stop& stop);

  [[nodiscard]] const TraceCounts& counts() const { return counts_; }
  // Whether nothing can be seen through a pixel of the crop, so that its samples are not traced.
  [[nodiscard]] bool skips(std::uint64_t pixel) const {
    return skipsTiles_ && isEmpty(starts_, static_cast<std::uint32_t>(pixel), constants_.cropWidth);
  }
  [[nodiscard]] std::uint64_t skippedPixels() const { return skippedPixels_; }
  // Bytes of the scene's arrays and of the work on the device.
  [[nodiscard]] std::size_t deviceBytes() const;

 private:
  std::uint32_t makePiece(std::uint64_t first, std::uint32_t count, const MakeItems& makeItems);
  void takePiece(std::uint64_t first, std::uint32_t count, const TakeResults& takeResults);
  void dispatchUntilFinished(std::uint32_t count);
  gpu::DispatchStatus dispatch(vulkan::ComputeShader& shader, std::uint32_t count, gpu::uint mode);
  vulkan::ComputeShader makeShader(bool resumable);

  vulkan::Device& device_;
  bool centerOnly_;
  TileStarts starts_;
  bool skipsTiles_;  // those without a start
  std::uint64_t skippedPixels_ = 0;
  gpu::DispatchConstants constants_{};
  std::uint32_t capacity_;                 // items of the largest piece
  double pieceItems_;                      // of the next piece
  bool isWarm_ = false;                    // after the first piece
  std::vector<vulkan::Buffer> buffers_;    // by binding
  std::span<const std::uint32_t> shader_;  // SPIR-V
  std::vector<std::uint32_t> specialization_;
  // One of them: the first, unless the scene has too many lights for it, until it gives an item up.
  std::optional<vulkan::ComputeShader> direct_;
  std::optional<vulkan::ComputeShader> resumable_;
  // Of a piece where tiles are skipped: the places of the items that are traced, and all results.
  std::vector<std::uint32_t> places_;
  std::vector<gpu::WorkResult> allResults_;
  TraceCounts counts_;
};

}  // namespace lavaray
