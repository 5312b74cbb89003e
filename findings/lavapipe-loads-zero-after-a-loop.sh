#!/bin/bash
# Mesa 22.3.6 (Debian 12), lavapipe: what a loop reads from a buffer, and the invocation uses after the loop, is 0 for
# each invocation that leaves the loop before the last one of its subgroup does. A good engineer expects the value of the
# last turn, as on any device. Here each of eight invocations makes one turn more than the one before it, and so reads one
# word further; what it computes from registers alone is right. The shader is valid, and nothing warns of it.
#
# What crosses from turn to turn is right as well. Mesa 25.0.7 with the same LLVM 15 reads what it should.
set -euo pipefail
tools=$(cd "$(dirname "$0")/../tools" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export MESA_SHADER_CACHE_DISABLE=true
# unpack SUITE VERSION: Mesa's driver and the loader as that suite of Debian has them.
unpack() {
  "$tools/unpack-debian" "$1" "$1" mesa-vulkan-drivers libvulkan1 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
  grep -qx "mesa-vulkan-drivers $2" "$1/versions" ||
    { echo "Debian's $1 no longer has version $2 of mesa-vulkan-drivers" >&2; exit 1; }
}
unpack bookworm 22.3.6-1+deb12u2
unpack bookworm-backports 25.0.7-2~bpo12+1
apt-get download -q glslang-tools=12.0.0-2 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
dpkg-deb -x glslang-tools_*.deb glslang
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

cat > last.comp <<'GLSL'
#version 450
layout(local_size_x = 8) in;
layout(std430, binding = 0) buffer Words { uint given[8], read[8], computed[8]; };
void main() {
  uint turn = 0u, last, square;
  do {
    last = given[turn];
    square = turn * turn;
    ++turn;
  } while (turn <= gl_LocalInvocationIndex);
  read[gl_LocalInvocationIndex] = last;
  computed[gl_LocalInvocationIndex] = square;
}
GLSL
glslang/usr/bin/glslangValidator --quiet -V last.comp -o last.spv
cat > compute.py <<'PYTHON'
import struct, sys
import vulkan as vk

def compute(module, words):
    """Runs a module over a buffer that begins with these 32-bit words, and returns the buffer's 32 words."""
    application = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
    instance = vk.vkCreateInstance(vk.VkInstanceCreateInfo(pApplicationInfo=application), None)
    queues = [vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, pQueuePriorities=[1.0])]
    device = vk.vkCreateDevice(vk.vkEnumeratePhysicalDevices(instance)[0],
                               vk.VkDeviceCreateInfo(pQueueCreateInfos=queues), None)
    kind, stage = vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, vk.VK_SHADER_STAGE_COMPUTE_BIT
    bufferInfo = vk.VkBufferCreateInfo(size=128, usage=vk.VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)
    buffer = vk.vkCreateBuffer(device, bufferInfo, None)
    memory = vk.vkAllocateMemory(device, vk.VkMemoryAllocateInfo(allocationSize=4096, memoryTypeIndex=0), None)
    vk.vkBindBufferMemory(device, buffer, memory, 0)
    mapped = vk.vkMapMemory(device, memory, 0, 128, 0)
    mapped[:] = struct.pack('32I', *words, *[0] * (32 - len(words)))
    binding = vk.VkDescriptorSetLayoutBinding(binding=0, descriptorType=kind, descriptorCount=1, stageFlags=stage)
    setLayout = vk.vkCreateDescriptorSetLayout(device, vk.VkDescriptorSetLayoutCreateInfo(pBindings=[binding]), None)
    sizes = [vk.VkDescriptorPoolSize(type=kind, descriptorCount=1)]
    pool = vk.vkCreateDescriptorPool(device, vk.VkDescriptorPoolCreateInfo(maxSets=1, pPoolSizes=sizes), None)
    sets = vk.vkAllocateDescriptorSets(
        device, vk.VkDescriptorSetAllocateInfo(descriptorPool=pool, pSetLayouts=[setLayout]))
    buffers = [vk.VkDescriptorBufferInfo(buffer=buffer, offset=0, range=128)]
    vk.vkUpdateDescriptorSets(device, 1, [vk.VkWriteDescriptorSet(
        dstSet=sets[0], dstBinding=0, descriptorCount=1, descriptorType=kind, pBufferInfo=buffers)], 0, None)
    code = open(module, 'rb').read()
    shader = vk.vkCreateShaderModule(device, vk.VkShaderModuleCreateInfo(codeSize=len(code), pCode=code), None)
    layout = vk.vkCreatePipelineLayout(device, vk.VkPipelineLayoutCreateInfo(pSetLayouts=[setLayout]), None)
    entry = vk.VkPipelineShaderStageCreateInfo(stage=stage, module=shader, pName='main')
    pipeline = vk.vkCreateComputePipelines(
        device, None, 1, [vk.VkComputePipelineCreateInfo(stage=entry, layout=layout)], None)[0]
    commandPool = vk.vkCreateCommandPool(device, vk.VkCommandPoolCreateInfo(queueFamilyIndex=0), None)
    commands = vk.vkAllocateCommandBuffers(device, vk.VkCommandBufferAllocateInfo(
        commandPool=commandPool, level=vk.VK_COMMAND_BUFFER_LEVEL_PRIMARY, commandBufferCount=1))[0]
    vk.vkBeginCommandBuffer(commands, vk.VkCommandBufferBeginInfo())
    vk.vkCmdBindPipeline(commands, vk.VK_PIPELINE_BIND_POINT_COMPUTE, pipeline)
    vk.vkCmdBindDescriptorSets(commands, vk.VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, sets, 0, None)
    vk.vkCmdDispatch(commands, 1, 1, 1)
    vk.vkEndCommandBuffer(commands)
    queue = vk.vkGetDeviceQueue(device, 0, 0)
    vk.vkQueueSubmit(queue, 1, [vk.VkSubmitInfo(pCommandBuffers=[commands])], None)
    vk.vkQueueWaitIdle(queue)
    return struct.unpack('32I', bytes(mapped[:]))

words = compute('last.spv', [11, 12, 13, 14, 15, 16, 17, 18])
print('read', *words[8:16], ' computed', *words[16:24])
PYTHON
for suite in bookworm bookworm-backports; do
  echo "$(awk '/^mesa-vulkan/ { print $2 }' $suite/versions): $($suite/run venv/bin/python compute.py)"
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2: read 0 0 0 0 0 0 0 18  computed 0 1 4 9 16 25 36 49
25.0.7-2~bpo12+1: read 11 12 13 14 15 16 17 18  computed 0 1 4 9 16 25 36 49
EXPECTED
