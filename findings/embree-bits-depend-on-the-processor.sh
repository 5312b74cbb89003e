#!/bin/bash
# Embree 3.13.5 (Debian 12): the same scene and the same rays have other distances, in the last bits, on processors with
# other vector instructions: one set of bits for SSE2 to AVX, another for AVX2, a third for AVX-512. A good engineer expects
# IEEE arithmetic to be the same everywhere, since the library has no option for fast arithmetic.
#
# The library is compiled once for each set, and picks one when it runs. So reference images made with it on one machine
# need a tolerance on another, unless the set is given, as in rtcNewDevice("isa=avx2"), and every machine has it.
#
# It takes a processor with AVX-512 to show all three; sets that this one lacks are passed over.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libembree-dev=3.13.5+dfsg-2 libembree3-3=3.13.5+dfsg-2 libtbb12=2021.8.0-2+deb12u1 > apt.log 2>&1 ||
  { cat apt.log >&2; exit 1; }
for package in *.deb; do dpkg-deb -x "$package" root; done
libraries=$folder/root/usr/lib/x86_64-linux-gnu

cat > rays.c <<'C'
#include <embree3/rtcore.h>
#include <stdio.h>
#include <string.h>
int main(int count, char** arguments) {
  (void)count;
  RTCDevice device = rtcNewDevice(arguments[1]);
  RTCScene scene = rtcNewScene(device);
  RTCGeometry triangle = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const float corners[9] = {-1.1f, -0.7f, 3.3f, 1.3f, -0.9f, 2.9f, 0.1f, 1.7f, 3.7f};
  const unsigned indices[3] = {0, 1, 2};
  memcpy(rtcSetNewGeometryBuffer(triangle, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3), corners, 36);
  memcpy(rtcSetNewGeometryBuffer(triangle, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, 1), indices, 12);
  rtcCommitGeometry(triangle);
  rtcAttachGeometry(scene, triangle);
  rtcCommitScene(scene);
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  int hits = 0;
  unsigned hash = 0;
  for (int i = 0; i < 1000; ++i) {
    struct RTCRayHit ray = {{0}};
    ray.ray.dir_x = (float)(i % 37 - 18) * 0.01f;
    ray.ray.dir_y = (float)(i % 29 - 14) * 0.011f;
    ray.ray.dir_z = 1.0f;
    ray.ray.tfar = 1e30f;
    ray.ray.mask = 0xFFFFFFFFu;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    unsigned bits;
    memcpy(&bits, &ray.ray.tfar, 4);
    hash = hash * 31 + bits;
    ++hits;
  }
  printf("%s: %d hits, hash of the distances' bits %08x\n", arguments[1], hits, hash);
}
C
gcc -Wall -Iroot/usr/include rays.c -o rays "$libraries/libembree3.so.3" -Wl,-rpath-link,"$libraries"
for set in sse2:sse2 sse4.2:sse4_2 avx:avx avx2:avx2 avx512:avx512vl; do
  grep -qw "${set#*:}" /proc/cpuinfo || { echo "${set%:*}: not on this processor" >&2; continue; }
  LD_LIBRARY_PATH=$libraries ./rays "isa=${set%:*}"
done | tee seen.txt

cat > expected.txt <<'EXPECTED'
isa=sse2: 979 hits, hash of the distances' bits e8ba630e
isa=sse4.2: 979 hits, hash of the distances' bits e8ba630e
isa=avx: 979 hits, hash of the distances' bits e8ba630e
isa=avx2: 979 hits, hash of the distances' bits 9f7c6c1d
isa=avx512: 979 hits, hash of the distances' bits af3e532c
EXPECTED
[ "$(wc -l < seen.txt)" -ge 4 ]
diff seen.txt <(head -n "$(wc -l < seen.txt)" expected.txt)
