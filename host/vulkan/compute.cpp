#include "vulkan/compute.hpp"

#include <vector>

#include "vulkan/result.hpp"

namespace lavaray::vulkan {
ComputeShader::ComputeShader(Device& device, std::span<const std::uint32_t> spirv,
                             std::span<const std::uint32_t> specialization, std::span<const Buffer> buffers,
                             std::size_t pushConstantSize, std::span<const Buffer> ownBuffers)
    : device_(&device) {
  std::vector<const Buffer*> all;
  for (const Buffer& buffer : buffers) all.push_back(&buffer);
  for (const Buffer& buffer : ownBuffers) all.push_back(&buffer);
  std::vector<VkDescriptorType> bindings;
  for (const Buffer* buffer : all) bindings.push_back(descriptorType(buffer->use()));
  pipeline_ = device.pipelines().get({spirv, specialization, bindings, pushConstantSize});
  createSet(all);
  work_ = std::make_unique<Submission>(device);
}

void ComputeShader::createSet(std::span<const Buffer* const> buffers) {
  const auto count = static_cast<std::uint32_t>(buffers.size());
  const std::string what = "for the shader's " + std::to_string(count) + " buffers";
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Buffer* buffer : buffers) sizes.push_back({descriptorType(buffer->use()), 1});
  VkDescriptorPoolCreateInfo poolInfo{};
  poolInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = count;
  poolInfo.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_->get(), &poolInfo, nullptr, &pool), "make a descriptor pool " + what);
  pool_ = {device_->get(), pool};

  const VkDescriptorSetLayout layout = pipeline_->setLayout();
  VkDescriptorSetAllocateInfo setInfo{};
  setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  setInfo.descriptorPool = pool;
  setInfo.descriptorSetCount = 1;
  setInfo.pSetLayouts = &layout;
  check(vkAllocateDescriptorSets(device_->get(), &setInfo, &set_), "make a descriptor set " + what);

  std::vector<VkDescriptorBufferInfo> ranges(count);
  std::vector<VkBufferView> views(count);
  std::vector<VkWriteDescriptorSet> writes(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ranges[i] = {buffers[i]->get(), 0, VK_WHOLE_SIZE};
    views[i] = buffers[i]->view();
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set_;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = descriptorType(buffers[i]->use());
    writes[i].pBufferInfo = &ranges[i];
    writes[i].pTexelBufferView = &views[i];
  }
  vkUpdateDescriptorSets(device_->get(), count, writes.data(), 0, nullptr);
}

void ComputeShader::start(std::uint32_t groups, std::span<const std::byte> pushConstants) {
  work_->submit([&](VkCommandBuffer commands) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_->get());
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_->layout(), 0, 1, &set_, 0,
                            nullptr);
    if (!pushConstants.empty()) {
      vkCmdPushConstants(commands, pipeline_->layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
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

void ComputeShader::wait() {
  work_->wait();
}

void ComputeShader::dispatch(std::uint32_t groups, std::span<const std::byte> pushConstants) {
  start(groups, pushConstants);
  wait();
}

}  // namespace lavaray::vulkan
