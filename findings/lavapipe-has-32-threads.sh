#!/bin/bash
# lavapipe computes on at most 32 threads, whatever the machine has: from 33 processors on, more of them are no use to one
# process. LP_NUM_THREADS, whose name promises more, is cut off at 32 as well, without a word. A good engineer expects a
# software renderer that starts "a thread for each processor" to do so on a server with 64 or 192 of them, and buys it.
#
# Mesa 22.3.6 (Debian 12) and 26.2.6 alike. Several processes fill a larger machine.
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
unpack unstable 26.2.6-1
python3 -m venv venv
venv/bin/pip install -q --disable-pip-version-check vulkan==1.3.275.1 cffi==1.17.1

cat > device.py <<'PYTHON'
import os
import vulkan as vk

application = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
instance = vk.vkCreateInstance(vk.VkInstanceCreateInfo(pApplicationInfo=application), None)
queues = [vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, pQueuePriorities=[1.0])]
device = vk.vkCreateDevice(vk.vkEnumeratePhysicalDevices(instance)[0],
                           vk.VkDeviceCreateInfo(pQueueCreateInfos=queues), None)
names = [open(f'/proc/self/task/{task}/comm').read() for task in os.listdir('/proc/self/task')]
print(sum(name.startswith('llvmpipe') for name in names))
PYTHON
for suite in bookworm unstable; do
  for threads in 8 32 33 192; do
    echo "$(awk '/^mesa-vulkan/ { print $2 }' $suite/versions), $threads wanted:" \
      "$(LP_NUM_THREADS=$threads $suite/run venv/bin/python device.py)"
  done
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
22.3.6-1+deb12u2, 8 wanted: 8
22.3.6-1+deb12u2, 32 wanted: 32
22.3.6-1+deb12u2, 33 wanted: 32
22.3.6-1+deb12u2, 192 wanted: 32
26.2.6-1, 8 wanted: 8
26.2.6-1, 32 wanted: 32
26.2.6-1, 33 wanted: 32
26.2.6-1, 192 wanted: 32
EXPECTED
