#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "bvh/gpu_scene.hpp"
#include "render/batch.hpp"
#include "render/entry_nodes.hpp"
#include "render/settings.hpp"
#include "render/trace_counts.hpp"
#include "render/variant.hpp"
#include "sampling/sample_pass.hpp"

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

  // Does the items of the pass from number `first` on, in their order, in batches, and has their results
  // taken. Looks at `stop` before each batch; once that is true, it takes the results of what the device has
  // been given, and returns false. Throws Error(kDevice) where the device fails or cannot finish a ray.
  bool run(const SamplePass& pass, std::uint64_t first, const TakeResults& takeResults, const Stop& stop);

  // The steps of run(). The device has up to two batches, so that it traces one while the host takes the
  // results of another and prepares the next.
  [[nodiscard]] bool canBegin() const { return begun_ - taken_ < kBatchesInFlight; }
  [[nodiscard]] bool isIdle() const { return begun_ == taken_; }
  // Has the device trace the items of the pass from number `first` on, as many as take it some 10s of
  // milliseconds, and returns how many. With one sample in each pixel's centre, item i is pixel i.
  std::uint32_t begin(const SamplePass& pass, std::uint64_t first);
  // Waits for the batch that was begun first, and has its results taken.
  void take(const TakeResults& takeResults);

  [[nodiscard]] const TraceCounts& counts() const { return counts_; }
  // Of all dispatches so far, if the settings have times recorded.
  [[nodiscard]] vulkan::Activity activity() const { return activity_.activity(); }
  // Whether nothing can be seen through a pixel of the area, so that its samples are not traced.
  [[nodiscard]] bool skips(std::uint64_t pixel) const {
    return variant_.skipsEmptyTiles &&
           isEmpty(entryNodes_, static_cast<std::uint32_t>(pixel), constants_.areaWidth);
  }
  [[nodiscard]] std::uint64_t skippedPixels() const { return skippedPixels_; }
  [[nodiscard]] Tuning tuning() const {
    return {variant_.sceneUse == vulkan::BufferUse::kStorage, variant_.raysPerLane};
  }
  // Bytes of the scene's arrays and of the work on the device.
  [[nodiscard]] std::size_t deviceBytes() const;

 private:
  static constexpr std::size_t kBatchesInFlight = 2;

  [[nodiscard]] Batch& batchAt(std::uint64_t number) { return batches_[number % kBatchesInFlight]; }
  [[nodiscard]] std::uint32_t batchCount(std::uint64_t items, std::uint64_t first) const;
  [[nodiscard]] std::uint32_t lanes(const Batch& batch, std::uint32_t raysPerLane) const;
  void listItems(const SamplePass& pass, Batch& batch) const;
  void takeResultsOf(Batch& batch, const TakeResults& takeResults) const;
  void adaptBatch(const Batch& batch);
  void start(Batch& batch, vulkan::ComputeShader& shader, gpu::uint mode);
  gpu::DispatchStatus wait(Batch& batch, vulkan::ComputeShader& shader);
  void finish(Batch& batch);
  void makeShader(Batch& batch, bool resumable);

  vulkan::Device& device_;
  PipelineVariant variant_;
  bool takesCenters_;
  EntryNodes entryNodes_;
  std::uint64_t skippedPixels_ = 0;
  gpu::DispatchConstants constants_{};
  std::uint32_t capacity_;  // items of the largest batch
  double batchItems_;       // of the next batch
  bool isWarm_ = false;     // after the first batch
  Batch::Clock::time_point lastTaken_;
  std::vector<vulkan::Buffer> sceneBuffers_;     // by binding
  std::array<Batch, kBatchesInFlight> batches_;  // go first, as the device may work with all of these
  std::uint64_t begun_ = 0;                      // batches
  std::uint64_t taken_ = 0;
  TraceCounts counts_;
  bool recordsTimes_;
  vulkan::ActivityLog activity_;
};

}  // namespace lavaray
