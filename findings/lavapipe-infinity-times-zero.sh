#!/bin/bash
# Mesa's lavapipe computes infinity * 0.0 as 0, even where GLSL says `precise`, if the 0.0 is a literal; if it comes from a
# buffer, the product is no number, as IEEE 754 has it. `precise` and NoContraction forbid to fuse and to reorder, but
# Vulkan lets a driver take infinities and NaN for absent until the module asks for SignedZeroInfNanPreserve, for which
# GLSL has no word. So a mask that multiplies by a constant 0 behaves otherwise than one that multiplies by a variable 0.
#
# Mesa 22.3.6 (Debian 12) says that it supports SignedZeroInfNanPreserve, and gives 0 all the same. 25.0.7 obeys.
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
apt-get download -q glslang-tools=12.0.0-2 spirv-tools=2023.1-2 > apt.log 2>&1 ||
  { cat apt.log >&2; exit 1; }
for package in *.deb; do dpkg-deb -x "$package" tools; done
export PATH=$folder/tools/usr/bin:$PATH
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

cat > product.comp <<'GLSL'
#version 450
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Numbers { float infinity, zero, byLiteral, byVariable; };
void main() {
  precise float literal = infinity * 0.0;
  precise float variable = infinity * zero;
  byLiteral = literal;
  byVariable = variable;
}
GLSL
glslangValidator --quiet -V product.comp -o precise.spv
spirv-dis precise.spv | sed '
  s/OpCapability Shader/&\nOpCapability SignedZeroInfNanPreserve\nOpExtension "SPV_KHR_float_controls"/
  s/OpExecutionMode %main .*/&\nOpExecutionMode %main SignedZeroInfNanPreserve 32/' > preserve.txt
spirv-as --target-env spv1.0 preserve.txt -o preserve.spv
spirv-val --target-env vulkan1.1 preserve.spv
cat > compute.py <<'PYTHON'
import struct, sys
import vulkan as vk

def compute(module, words):
    """Runs a module once over a buffer that begins with these 32-bit words, returns whether infinities can be preserved and the buffer."""
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
    controls = vk.VkPhysicalDeviceFloatControlsProperties()
    vk.vkGetPhysicalDeviceProperties2(physical, vk.VkPhysicalDeviceProperties2(pNext=controls))
    return controls.shaderSignedZeroInfNanPreserveFloat32, struct.unpack('32f', bytes(mapped[:]))

preserves, numbers = compute(sys.argv[1] + '.spv', [float('inf'), 0.0])
print(f'{sys.argv[1]}: by a literal {numbers[2]:g}, by a variable {abs(numbers[3]):g}; can preserve: {preserves}')
PYTHON
for suite in bookworm bookworm-backports; do
  for module in precise preserve; do
    echo "$(awk '/^mesa-vulkan/ { print $2 }' $suite/versions) $($suite/run venv/bin/python compute.py $module)"
  done
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2 precise: by a literal 0, by a variable nan; can preserve: 1
22.3.6-1+deb12u2 preserve: by a literal 0, by a variable nan; can preserve: 1
25.0.7-2~bpo12+1 precise: by a literal 0, by a variable nan; can preserve: 1
25.0.7-2~bpo12+1 preserve: by a literal nan, by a variable nan; can preserve: 1
EXPECTED
