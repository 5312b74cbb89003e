#include "vulkan/pipeline.hpp"

#include <algorithm>
#include <exception>
#include <string>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {
namespace {

// More than most runs of many scenes need. Every edit of a shader under --watch makes a new one, which takes
// some megabytes.
constexpr std::size_t kMaxKept = 32;

}  // namespace

Pipeline::Pipeline(VkDevice device, const PipelineSource& source) {
  createLayouts(device, source);
  const std::string what =
      "the shader (" + std::to_string((source.spirv.size_bytes() + 1023) / 1024) + " KiB of SPIR-V)";

  VkShaderModuleCreateInfo moduleInfo{};
  moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  moduleInfo.codeSize = source.spirv.size_bytes();
  moduleInfo.pCode = source.spirv.data();
  VkShaderModule rawModule = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device, &moduleInfo, nullptr, &rawModule), "load " + what);
  const Handle<VkShaderModule, &vkDestroyShaderModule> shaderModule(device, rawModule);

  std::vector<VkSpecializationMapEntry> entries;
  for (std::uint32_t i = 0; i < source.specialization.size(); ++i) entries.push_back({i, i * 4, 4});
  const VkSpecializationInfo specialization{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                            source.specialization.size_bytes(), source.specialization.data()};

  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = rawModule;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &specialization;
  info.layout = layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "make a pipeline of " + what);
  pipeline_ = {device, pipeline};
}

void Pipeline::createLayouts(VkDevice device, const PipelineSource& source) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t i = 0; i < source.bindings.size(); ++i) {
    bindings.push_back({i, source.bindings[i], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  }
  VkDescriptorSetLayoutCreateInfo setInfo{};
  setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
  setInfo.pBindings = bindings.data();
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device, &setInfo, nullptr, &setLayout),
        "lay out the shader's " + std::to_string(bindings.size()) + " buffers");
  setLayout_ = {device, setLayout};

  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0,
                                  static_cast<std::uint32_t>(source.pushConstantSize)};
  VkPipelineLayoutCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  info.setLayoutCount = 1;
  info.pSetLayouts = &setLayout;
  info.pushConstantRangeCount = source.pushConstantSize > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device, &info, nullptr, &layout),
        "make the layout of the shader's pipeline (" + std::to_string(source.pushConstantSize) +
            " bytes of constants)");
  layout_ = {device, layout};
}

Pipelines::Kept::Kept(const PipelineSource& source)
    : spirv(source.spirv.begin(), source.spirv.end()),
      specialization(source.specialization.begin(), source.specialization.end()),
      bindings(source.bindings.begin(), source.bindings.end()),
      pushConstantSize(source.pushConstantSize) {}

bool Pipelines::Kept::isOf(const PipelineSource& source) const {
  return pushConstantSize == source.pushConstantSize &&
         std::ranges::equal(specialization, source.specialization) &&
         std::ranges::equal(bindings, source.bindings) && std::ranges::equal(spirv, source.spirv);
}

Pipelines::Made Pipelines::make(const PipelineSource& source) {
  std::promise<std::shared_ptr<const Pipeline>> promise;
  Made made;
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find_if(kept_, [&](const Kept& kept) { return kept.isOf(source); });
    if (known != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, known);
      return kept_.front().made;
    }
    kept_.emplace_front(source);
    made = kept_.front().made = promise.get_future().share();
    if (kept_.size() > kMaxKept) kept_.pop_back();
  }
  try {
    promise.set_value(std::make_shared<const Pipeline>(device_, source));
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return made;
}

std::shared_ptr<const Pipeline> Pipelines::get(const PipelineSource& source) {
  const Made made = make(source);
  try {
    return made.get();
  } catch (...) {
    // Another attempt may fare better.
    const std::lock_guard lock(mutex_);
    kept_.remove_if([&](const Kept& kept) { return kept.isOf(source); });
    throw;
  }
}

void Pipelines::prepare(const PipelineSource& source) noexcept {
  try {
    make(source);
  } catch (...) {
    // There was not even room to remember it: get() tries for itself.
  }
}

void Pipelines::clear() {
  const std::lock_guard lock(mutex_);
  kept_.clear();
}

}  // namespace lavaray::vulkan
