#include "vulkan/compute.hpp"

#include <array>

namespace lavaray::vulkan {
namespace {

// What is done, for messages.
constexpr const char* kBinding = "give the shader its data";
constexpr const char* kPreparing = "prepare the shader for the device";

VkDescriptorType descriptorType(const Buffer& buffer) {
  return buffer.use() == BufferUse::kTexels ? VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER
                                            : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

}  // namespace

ComputeShader::ComputeShader(Device& device, std::span<const std::uint32_t> spirv,
                             std::span<const std::uint32_t> specialization, std::span<const Buffer> buffers,
                             std::size_t pushConstantSize)
    : device_(&device) {
  createSet(buffers);
  createPipeline(spirv, specialization, pushConstantSize);
}

void ComputeShader::createSet(std::span<const Buffer> buffers) {
  const auto count = static_cast<std::uint32_t>(buffers.size());
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  std::vector<VkDescriptorPoolSize> sizes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const VkDescriptorType type = descriptorType(buffers[i]);
    bindings.push_back({i, type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    sizes.push_back({type, 1});
  }
  VkDescriptorSetLayoutCreateInfo layoutInfo{};
  layoutInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  layoutInfo.bindingCount = count;
  layoutInfo.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device_->get(), &layoutInfo, nullptr, &layout), kBinding);
  setLayout_ = {device_->get(), layout};

  VkDescriptorPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = count;
  poolInfo.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_->get(), &poolInfo, nullptr, &pool), kBinding);
  pool_ = {device_->get(), pool};

  VkDescriptorSetAllocateInfo setInfo{};
  setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  setInfo.descriptorPool = pool;
  setInfo.descriptorSetCount = 1;
  setInfo.pSetLayouts = &layout;
  check(vkAllocateDescriptorSets(device_->get(), &setInfo, &set_), kBinding);

  std::vector<VkDescriptorBufferInfo> ranges(count);
  std::vector<VkBufferView> views(count);
  std::vector<VkWriteDescriptorSet> writes(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ranges[i] = {buffers[i].get(), 0, VK_WHOLE_SIZE};
    views[i] = buffers[i].view();
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set_;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = descriptorType(buffers[i]);
    writes[i].pBufferInfo = &ranges[i];
    writes[i].pTexelBufferView = &views[i];
  }
  vkUpdateDescriptorSets(device_->get(), count, writes.data(), 0, nullptr);
}

void ComputeShader::createPipeline(std::span<const std::uint32_t> spirv,
                                   std::span<const std::uint32_t> specialization,
                                   std::size_t pushConstantSize) {
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0,
                                  static_cast<std::uint32_t>(pushConstantSize)};
  const VkDescriptorSetLayout setLayout = setLayout_.get();
  VkPipelineLayoutCreateInfo layoutInfo{};
  layoutInfo.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layoutInfo.setLayoutCount = 1;
  layoutInfo.pSetLayouts = &setLayout;
  layoutInfo.pushConstantRangeCount = pushConstantSize > 0 ? 1 : 0;
  layoutInfo.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device_->get(), &layoutInfo, nullptr, &layout), kPreparing);
  pipelineLayout_ = {device_->get(), layout};

  VkShaderModuleCreateInfo moduleInfo{};
  moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  moduleInfo.codeSize = spirv.size_bytes();
  moduleInfo.pCode = spirv.data();
  VkShaderModule rawModule = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device_->get(), &moduleInfo, nullptr, &rawModule), kPreparing);
  const Handle<VkShaderModule, &vkDestroyShaderModule> shaderModule(device_->get(), rawModule);

  std::vector<VkSpecializationMapEntry> entries;
  for (std::uint32_t i = 0; i < specialization.size(); ++i) entries.push_back({i, i * 4, 4});
  const VkSpecializationInfo specializationInfo{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                                specialization.size_bytes(), specialization.data()};

  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = rawModule;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &specializationInfo;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device_->get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), kPreparing);
  pipeline_ = {device_->get(), pipeline};
}

void ComputeShader::dispatch(std::uint32_t groups, std::span<const std::byte> pushConstants) {
  device_->submit([&](VkCommandBuffer commands) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipelineLayout_.get(), 0, 1, &set_, 0,
                            nullptr);
    if (!pushConstants.empty()) {
      vkCmdPushConstants(commands, pipelineLayout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                         static_cast<std::uint32_t>(pushConstants.size()), pushConstants.data());
    }
    vkCmdDispatch(commands, groups, 1, 1);
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
  });
}

}  // namespace lavaray::vulkan
