#!/bin/bash
# SPIRV-Tools 2023.1 (Debian 12): unrolling a loop copies its operations, but not their NoContraction. The passes of -Os
# unroll in their midst, so the next one fuses what GLSL's `precise` forbids to fuse: of four turns of a precise
# a * b + c, the first stays a product and a sum, the other three become Fma, which rounds once instead of twice. The
# module is valid, and only a device that fuses shows other bits.
#
# Who unrolls has to mark the operations again before anything else is optimized.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q spirv-tools=2023.1-2 glslang-tools=12.0.0-2 > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
for package in *.deb; do dpkg-deb -x "$package" root; done
export PATH=$folder/root/usr/bin:$PATH

cat > sums.comp <<'GLSL'
#version 450
#extension GL_EXT_control_flow_attributes : require
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Numbers { float a[4]; float b[4]; float c[4]; float sums[4]; };
void main() {
  [[unroll]] for (int i = 0; i < 4; ++i) {
    precise float sum = a[i] * b[i] + c[i];
    sums[i] = sum;
  }
}
GLSL

count() { spirv-dis "$1" | grep -cE "$2" || true; }
describe() {
  echo "$1: $(count "$2" 'OpFMul|OpFAdd') products and sums, $(count "$2" NoContraction) marked NoContraction," \
    "$(count "$2" ' Fma ') Fma"
}
glslangValidator --quiet -V sums.comp -o given.spv
spirv-opt --ssa-rewrite --loop-unroll given.spv -o unrolled.spv
spirv-opt -Os given.spv -o small.spv
for module in given unrolled small; do spirv-val "$module.spv"; done
{
  describe 'as compiled' given.spv
  describe 'unrolled' unrolled.spv
  describe '-Os' small.spv
} | tee seen.txt

diff seen.txt - <<'EXPECTED'
as compiled: 2 products and sums, 2 marked NoContraction, 0 Fma
unrolled: 8 products and sums, 2 marked NoContraction, 0 Fma
-Os: 2 products and sums, 2 marked NoContraction, 3 Fma
EXPECTED
