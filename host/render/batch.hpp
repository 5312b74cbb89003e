#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "interface.h"
#include "vulkan/compute.hpp"

namespace lavaray {

// Work items that are traced together, and the buffers and shaders for them: a batch can be prepared, and its
// results taken, while the device traces another one.
struct Batch {
  using Clock = std::chrono::steady_clock;

  std::vector<vulkan::Buffer> buffers;  // from gpu::kBindingWork on
  // They go before the buffers. There is one of the two, or both where the first gives up on some items.
  std::optional<vulkan::ComputeShader> direct;
  std::optional<vulkan::ComputeShader> resumable;
  bool canResume = false;  // there is a buffer for items that are left half done

  std::uint64_t first = 0;   // of its items, their number in the pass
  std::uint32_t count = 0;   // of its items
  std::uint32_t traced = 0;  // items that are traced; those in empty tiles are not
  std::uint64_t samples = 0;
  std::uint64_t skippedSamples = 0;
  Clock::time_point begin;
  // Where empty tiles are skipped: the numbers of the items that are traced, and the results of all.
  std::vector<std::uint32_t> tracedItems;
  std::vector<gpu::WorkResult> allResults;
};

// Buffers for so many items, but those of unfinished ones. They are listed on the host unless they are
// consecutive pixels.
Batch makeBatch(vulkan::Device& device, std::uint32_t capacity, bool listsItems);
// Makes room for so many items to be left half done. Shaders that were made before are bound to a buffer that
// goes.
void makeStates(vulkan::Device& device, std::uint32_t capacity, Batch& batch);

// As the host sees them while the device does not work on the batch.
std::span<gpu::WorkItem> items(Batch& batch);  // `count`
const gpu::WorkResult* results(const Batch& batch);
gpu::DispatchStatus& status(Batch& batch);

std::size_t bytes(const Batch& batch);  // on the device

}  // namespace lavaray
