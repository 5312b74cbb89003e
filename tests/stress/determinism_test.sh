#!/usr/bin/env bash
# determinism_test.sh PROGRAMS SCENES SCRATCH: the same bits whatever number of threads and width of vectors lavapipe
# uses. It reads these when the driver is loaded, hence the processes. Mesa's shader cache is off: it must not hand
# one width's code to another. Other drivers ignore all that and must give the same bits, too.
set -eu
programs=$1 scenes=$2 scratch=$3
rm -rf "$scratch" && mkdir -p "$scratch"
export MESA_SHADER_CACHE_DISABLE=true
width=160
[ "${LAVARAY_STRESS:-}" != full ] || width=800

# scene and options: every kind of shape, mirrors, sampled lights, corner normals
jobs=("showcase" "extensions --spp 4" "shininess --target-error 0.01")
settings=("LP_NUM_THREADS=1" "LP_NUM_THREADS=2" "LP_NATIVE_VECTOR_WIDTH=128" "LP_NATIVE_VECTOR_WIDTH=256"
  "LP_NATIVE_VECTOR_WIDTH=512" "LP_NATIVE_VECTOR_WIDTH=128 LP_NUM_THREADS=1")
images=0
differing=0
for job in "${jobs[@]}"; do
  read -r scene options <<<"$job"
  # shellcheck disable=SC2086  # options are several words
  "$programs/lavaray" "$scenes/$scene.txt" $options --width "$width" -q -o "$scratch/$scene.pfm"
  for setting in "${settings[@]}"; do
    # shellcheck disable=SC2086
    env $setting "$programs/lavaray" "$scenes/$scene.txt" $options --width "$width" -q -o "$scratch/other.pfm"
    images=$((images + 1))
    if ! cmp -s "$scratch/$scene.pfm" "$scratch/other.pfm"; then
      differing=$((differing + 1))
      mv "$scratch/other.pfm" "$scratch/$scene-${setting// /-}.pfm"
      echo "FAILED: $scene $options differs with $setting"
    fi
  done
done
echo "figure: determinism: $differing of $images images differ, threads 1 and 2, vectors of 128, 256 and 512 bits"
[ "$differing" -eq 0 ] || exit 1
rm -rf "$scratch"
