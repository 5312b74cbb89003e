#!/bin/bash
# Mesa 22.3.6 and 25.0.7, lavapipe: the shader cache on disk does not know for how wide vectors a shader was compiled. A
# program that runs after another one with a smaller LP_NATIVE_VECTOR_WIDTH finds that one's machine code: its subgroups
# have 4 invocations, while Vulkan still says 8. A good engineer expects the variable to be part of what the cache looks
# shaders up by, or at least the two numbers to agree.
#
# It hits who compares widths, as tests of reproducibility do, and whoever shares a home folder between machines whose
# vectors differ. MESA_SHADER_CACHE_DISABLE=true, or a folder for each width, avoids it. Mesa 26.1.6 has it right.
set -euo pipefail
tools=$(cd "$(dirname "$0")/../tools" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# unpack SUITE VERSION: Mesa's driver and the loader as that suite of Debian has them.
unpack() {
  "$tools/unpack-debian" "$1" "$1" mesa-vulkan-drivers libvulkan1 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
  grep -qx "mesa-vulkan-drivers $2" "$1/versions" ||
    { echo "Debian's $1 no longer has version $2 of mesa-vulkan-drivers" >&2; exit 1; }
}
unpack bookworm 22.3.6-1+deb12u2
unpack bookworm-backports 25.0.7-2~bpo12+1
unpack trixie-backports 26.1.6-1~bpo13+1
apt-get download -q glslang-tools=12.0.0-2 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
dpkg-deb -x glslang-tools_*.deb glslang
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

# Sixteen invocations, each of which counts those of its subgroup.
cat > count.comp <<'GLSL'
#version 450
#extension GL_KHR_shader_subgroup_arithmetic : require
layout(local_size_x = 16) in;
layout(std430, binding = 0) buffer Words { uint sizes[16]; };
void main() { sizes[gl_LocalInvocationIndex] = subgroupAdd(1u); }
GLSL
glslang/usr/bin/glslangValidator --quiet -V --target-env vulkan1.1 count.comp -o count.spv
cat > compute.py <<'PYTHON'
import struct, sys
import vulkan as vk

def compute(module, words):
    """Runs a module once over a buffer that begins with these 32-bit words, returns the size of subgroups and the buffer."""
    application = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
    instance = vk.vkCreateInstance(vk.VkInstanceCreateInfo(pApplicationInfo=application), None)
    queues = [vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, pQueuePriorities=[1.0])]
    physical = vk.vkEnumeratePhysicalDevices(instance)[0]
    device = vk.vkCreateDevice(physical,
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
    subgroup = vk.VkPhysicalDeviceSubgroupProperties()
    vk.vkGetPhysicalDeviceProperties2(physical, vk.VkPhysicalDeviceProperties2(pNext=subgroup))
    return subgroup.subgroupSize, struct.unpack('32I', bytes(mapped[:]))

size, words = compute('count.spv', [])
print(f'{size} said, {words[0]} counted')
PYTHON
show() { # SUITE WIDTH
  echo "$(awk '/^mesa-vulkan/ { print $2 }' $1/versions), $2 bits:" \
    "$(MESA_SHADER_CACHE_DIR=$PWD/$1-cache LP_NATIVE_VECTOR_WIDTH=$2 $1/run venv/bin/python compute.py)"
}
for suite in bookworm bookworm-backports trixie-backports; do
  for width in 128 256; do show $suite $width; done
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2, 128 bits: 4 said, 4 counted
22.3.6-1+deb12u2, 256 bits: 8 said, 4 counted
25.0.7-2~bpo12+1, 128 bits: 4 said, 4 counted
25.0.7-2~bpo12+1, 256 bits: 8 said, 4 counted
26.1.6-1~bpo13+1, 128 bits: 4 said, 4 counted
26.1.6-1~bpo13+1, 256 bits: 8 said, 8 counted
EXPECTED
