#!/bin/bash
# The same SPIR-V rounds otherwise on three releases of Mesa's lavapipe. From 26.1 on it adds up dot(a, b) from the last
# component to the first, where earlier ones begin with the first. GLSL's `precise` does not help: glslang 12 does not
# pass it on to OpDot. With NoContraction on it, the order is the old one. And fma(a, b, c), `precise` or not, rounds
# its product and its sum until 26.1, but only once from 26.2 on, which spirv-opt -Os makes the worse: it writes an Fma
# for each a * b + c that is not precise.
#
# A good engineer expects a software driver to keep its bits from release to release, and fma to be fused or not.
# Vulkan leaves both open. The same bits on all come of sums that are written out, precise, and without fma.
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
unpack trixie-backports 26.1.6-1~bpo13+1
unpack unstable 26.2.6-1
apt-get download -q glslang-tools=12.0.0-2 spirv-tools=2023.1-2 > apt.log 2>&1 ||
  { cat apt.log >&2; exit 1; }
for package in *.deb; do dpkg-deb -x "$package" tools; done
export PATH=$folder/tools/usr/bin:$PATH
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

# 1 + 2^-24 + 2^-24 is 1 from the left, 1 + 2^-23 from the right. (1 + 2^-12)^2 - (1 + 2^-11) is 2^-24, or 0 if the product
# is rounded.
cat > sums.comp <<'GLSL'
#version 450
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Numbers { float a[3], one, factor, minus, added, fused; };
void main() {
  precise float product = dot(vec3(a[0], a[1], a[2]), vec3(one));
  added = product;
  precise float sum = fma(factor, factor, minus);
  fused = sum;
}
GLSL
glslangValidator --quiet -V sums.comp -o precise.spv
spirv-dis --raw-id precise.spv > sums.txt
dot=$(awk '/OpDot/ { print $1 }' sums.txt)
sed "0,/OpDecorate/s//OpDecorate $dot NoContraction\n&/" sums.txt > marked.txt
spirv-as --target-env spv1.0 --preserve-numeric-ids marked.txt -o marked.spv
spirv-val marked.spv
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
    mapped[:] = struct.pack('32f', *words, *[0] * (32 - len(words)))
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
    return struct.unpack('32f', bytes(mapped[:]))

given = [1.0, 2.0 ** -24, 2.0 ** -24, 1.0, 1.0 + 2.0 ** -12, -1.0 - 2.0 ** -11]
precise, marked = compute('precise.spv', given), compute('marked.spv', given)
print(f'dot - 1 is {precise[6] - 1:.3g}, marked {marked[6] - 1:.3g}; fma {precise[7]:.3g}')
PYTHON
for suite in bookworm trixie-backports unstable; do
  echo "$(awk '/^mesa-vulkan/ { print $2 }' $suite/versions): $($suite/run venv/bin/python compute.py)"
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2: dot - 1 is 0, marked 0; fma 0
26.1.6-1~bpo13+1: dot - 1 is 1.19e-07, marked 0; fma 0
26.2.6-1: dot - 1 is 1.19e-07, marked 0; fma 5.96e-08
EXPECTED
