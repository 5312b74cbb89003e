#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "vulkan/handle.hpp"

namespace lavaray::vulkan {

// All that determines what a driver makes of a compute shader.
struct PipelineSource {
  std::span<const std::uint32_t> spirv;
  std::span<const std::uint32_t> specialization;  // constant i is specialization[i]; a bool is 0 or 1
  std::span<const VkDescriptorType> bindings;     // of descriptor set 0
  std::size_t pushConstantSize;
};

// A shader as the driver has compiled it, without the buffers that it is to work on.
class Pipeline {
 public:
  Pipeline(VkDevice device, const PipelineSource& source);

  [[nodiscard]] VkDescriptorSetLayout setLayout() const { return setLayout_.get(); }
  [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
  [[nodiscard]] VkPipeline get() const { return pipeline_.get(); }

 private:
  void createLayouts(VkDevice device, const PipelineSource& source);

  Handle<VkDescriptorSetLayout, &vkDestroyDescriptorSetLayout> setLayout_;
  Handle<VkPipelineLayout, &vkDestroyPipelineLayout> layout_;
  Handle<VkPipeline, &vkDestroyPipeline> pipeline_;
};

// A device's most recently used pipelines: making one can take a driver longer than a whole render. Threads
// may ask for them together.
class Pipelines {
 public:
  explicit Pipelines(VkDevice device) : device_(device) {}

  // The one that was made from the same source, or a new one; waits for one that another thread is making.
  // Throws Error(kDevice) if it cannot be made, also where it was another thread that found that.
  std::shared_ptr<const Pipeline> get(const PipelineSource& source);
  // Makes the one that get() is expected to be asked for, while another thread does other work. If that
  // fails, get() tells.
  void prepare(const PipelineSource& source) noexcept;
  void clear();

 private:
  using Made = std::shared_future<std::shared_ptr<const Pipeline>>;
  struct Kept {
    explicit Kept(const PipelineSource& source);
    [[nodiscard]] bool isOf(const PipelineSource& source) const;

    std::vector<std::uint32_t> spirv;
    std::vector<std::uint32_t> specialization;
    std::vector<VkDescriptorType> bindings;
    std::size_t pushConstantSize;
    Made made;  // or being made
  };
  Made make(const PipelineSource& source);

  VkDevice device_;
  std::mutex mutex_;      // of the next one
  std::list<Kept> kept_;  // the most recently used first
};

}  // namespace lavaray::vulkan
