#!/bin/bash
# lavapipe's VkPipelineCache never holds anything: after a pipeline was made with it, vkGetPipelineCacheData has 32 bytes,
# the header that Vulkan prescribes, as before. Programs that save it, to spare the next run the compilation, save nothing,
# although every call succeeds. A good engineer expects at least the shader, as drivers of GPUs keep it, since for a
# driver that compiles by LLVM it is worth the most.
#
# What does last is Mesa's own cache, in MESA_SHADER_CACHE_DIR or the home folder, which a container or a service may not
# be able to write to. Mesa 22.3.6 (Debian 12) and 26.2.6 alike.
set -euo pipefail
tools=$(cd "$(dirname "$0")/../tools" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export MESA_SHADER_CACHE_DIR=$folder/cache
# unpack SUITE VERSION: Mesa's driver and the loader as that suite of Debian has them.
unpack() {
  "$tools/unpack-debian" "$1" "$1" mesa-vulkan-drivers libvulkan1 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
  grep -qx "mesa-vulkan-drivers $2" "$1/versions" ||
    { echo "Debian's $1 no longer has version $2 of mesa-vulkan-drivers" >&2; exit 1; }
}
unpack bookworm 22.3.6-1+deb12u2
unpack unstable 26.2.6-1
apt-get download -q glslang-tools=12.0.0-2 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
dpkg-deb -x glslang-tools_*.deb glslang
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

echo '#version 450
layout(local_size_x = 1) in;
void main() {}' > empty.comp
glslang/usr/bin/glslangValidator --quiet -V empty.comp -o empty.spv

cat > device.py <<'PYTHON'
import vulkan as vk

application = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
instance = vk.vkCreateInstance(vk.VkInstanceCreateInfo(pApplicationInfo=application), None)
queues = [vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, pQueuePriorities=[1.0])]
device = vk.vkCreateDevice(vk.vkEnumeratePhysicalDevices(instance)[0],
                           vk.VkDeviceCreateInfo(pQueueCreateInfos=queues), None)
code = open('empty.spv', 'rb').read()
shader = vk.vkCreateShaderModule(device, vk.VkShaderModuleCreateInfo(codeSize=len(code), pCode=code), None)
layout = vk.vkCreatePipelineLayout(device, vk.VkPipelineLayoutCreateInfo(), None)
cache = vk.vkCreatePipelineCache(device, vk.VkPipelineCacheCreateInfo(), None)

def cached():
    size = vk.ffi.new('size_t *')
    assert vk.lib.vkGetPipelineCacheData(device, cache, size, vk.ffi.NULL) == vk.VK_SUCCESS
    return size[0]

before = cached()
entry = vk.VkPipelineShaderStageCreateInfo(stage=vk.VK_SHADER_STAGE_COMPUTE_BIT, module=shader, pName='main')
vk.vkCreateComputePipelines(device, cache, 1, [vk.VkComputePipelineCreateInfo(stage=entry, layout=layout)], None)
print(f'{before} bytes before, {cached()} after')
PYTHON
for suite in bookworm unstable; do
  echo "$(awk '/^mesa-vulkan/ { print $2 }' $suite/versions): $($suite/run venv/bin/python device.py)"
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2: 32 bytes before, 32 after
26.2.6-1: 32 bytes before, 32 after
EXPECTED
