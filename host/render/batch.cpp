#include "render/batch.hpp"

namespace lavaray {
namespace {

std::byte* bytesAt(const Batch& batch, gpu::uint binding) {
  return batch.buffers[binding - gpu::kBindingWork].bytes();
}

}  // namespace

Batch makeBatch(vulkan::Device& device, std::uint32_t capacity, bool listsItems) {
  Batch batch;
  const auto add = [&](const char* name, std::size_t size) {
    batch.buffers.push_back(vulkan::Buffer::shared(device, name, size));
  };
  add("work items", (listsItems ? capacity : 1) * sizeof(gpu::WorkItem));
  add("results", capacity * sizeof(gpu::WorkResult));
  add("unfinished work", sizeof(gpu::WorkState));
  add("dispatch status", sizeof(gpu::DispatchStatus));
  return batch;
}

void makeStates(vulkan::Device& device, std::uint32_t capacity, Batch& batch) {
  batch.buffers[gpu::kBindingStates - gpu::kBindingWork] =
      vulkan::Buffer::shared(device, "unfinished work", capacity * sizeof(gpu::WorkState));
  batch.canResume = true;
}

std::span<gpu::WorkItem> items(Batch& batch) {
  return {reinterpret_cast<gpu::WorkItem*>(bytesAt(batch, gpu::kBindingWork)), batch.count};
}

const gpu::WorkResult* results(const Batch& batch) {
  return reinterpret_cast<const gpu::WorkResult*>(bytesAt(batch, gpu::kBindingResults));
}

gpu::DispatchStatus& status(Batch& batch) {
  return *reinterpret_cast<gpu::DispatchStatus*>(bytesAt(batch, gpu::kBindingStatus));
}

std::size_t bytes(const Batch& batch) {
  std::size_t sum = 0;
  for (const vulkan::Buffer& buffer : batch.buffers) sum += buffer.size();
  return sum;
}

}  // namespace lavaray
