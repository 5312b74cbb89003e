#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/entry_nodes.hpp"
#include "render/settings.hpp"
#include "render/trace_counts.hpp"
#include "render/variant.hpp"
#include "sampling/sample_pass.hpp"
#include "vulkan/compute.hpp"

namespace lavaray {

// A scene on a device, with the pipeline for what the scene has. It takes samples of the pixels of an area of
// the picture.
class Tracer {
 public:
  // `items` is about how many a run has; buffers are no larger than that takes. Throws Error(kDevice) where
  // the scene does not fit the device.
  Tracer(vulkan::Device& device, const GpuScene& scene, const RenderSettings& settings, const Rectangle& area,
         std::uint64_t items);

  // The results of work items that follow one another from number `first` on.
  using TakeResults = std::function<void(std::uint64_t first, std::span<const gpu::WorkResult> results)>;
  using Stop = std::function<bool()>;

  // Does the items of the pass from number `first` on, in their order, in batches of about a tenth of a
  // second each, and has their results taken. Looks at `stop` before each batch and returns false if it was
  // stopped. With one sample in each pixel's centre, item i is pixel i. Throws Error(kDevice) where the
  // device fails or cannot finish a ray.
  bool run(const SamplePass& pass, std::uint64_t first, const TakeResults& takeResults, const Stop& stop);

  [[nodiscard]] const TraceCounts& counts() const { return counts_; }
  // Whether nothing can be seen through a pixel of the area, so that its samples are not traced.
  [[nodiscard]] bool skips(std::uint64_t pixel) const {
    return variant_.skipsEmptyTiles &&
           isEmpty(entryNodes_, static_cast<std::uint32_t>(pixel), constants_.areaWidth);
  }
  [[nodiscard]] std::uint64_t skippedPixels() const { return skippedPixels_; }
  // Bytes of the scene's arrays and of the work on the device.
  [[nodiscard]] std::size_t deviceBytes() const;

 private:
  std::uint32_t makeBatch(const SamplePass& pass, std::uint64_t first, std::uint32_t count);
  void takeBatch(std::uint64_t first, std::uint32_t count, const TakeResults& takeResults);
  [[nodiscard]] std::uint32_t batchCount(std::uint64_t items, std::uint64_t first) const;
  [[nodiscard]] std::uint32_t lanes(std::uint32_t count) const;
  void adaptBatch(double seconds);
  void dispatchUntilFinished(std::uint32_t count);
  gpu::DispatchStatus dispatch(vulkan::ComputeShader& shader, std::uint32_t count, gpu::uint mode);
  vulkan::ComputeShader makeShader(bool resumable);

  vulkan::Device& device_;
  PipelineVariant variant_;
  bool takesCenters_;
  EntryNodes entryNodes_;
  std::uint64_t skippedPixels_ = 0;
  gpu::DispatchConstants constants_{};
  std::uint32_t capacity_;               // items of the largest batch
  double batchItems_;                    // of the next batch
  bool isWarm_ = false;                  // after the first batch
  std::vector<vulkan::Buffer> buffers_;  // by binding
  // One of the two: the first if the variant finishes items, until it gives up on one.
  std::optional<vulkan::ComputeShader> direct_;
  std::optional<vulkan::ComputeShader> resumable_;
  // Of a batch with skipped tiles: the numbers of the items that are traced, and the results of all.
  std::vector<std::uint32_t> traced_;
  std::vector<gpu::WorkResult> allResults_;
  TraceCounts counts_;
};

}  // namespace lavaray
