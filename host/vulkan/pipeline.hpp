#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
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

// A device's most recently used pipelines: making one can take a driver longer than a whole render.
class Pipelines {
 public:
  explicit Pipelines(VkDevice device) : device_(device) {}

  // The one that was made from the same source, or a new one.
  std::shared_ptr<const Pipeline> get(const PipelineSource& source);
  void clear() { kept_.clear(); }

 private:
  struct Kept {
    explicit Kept(const PipelineSource& source);
    [[nodiscard]] bool isOf(const PipelineSource& source) const;

    std::vector<std::uint32_t> spirv;
    std::vector<std::uint32_t> specialization;
    std::vector<VkDescriptorType> bindings;
    std::size_t pushConstantSize;
    std::shared_ptr<const Pipeline> pipeline;
  };

  VkDevice device_;
  std::list<Kept> kept_;  // the most recently used first
};

}  // namespace lavaray::vulkan
