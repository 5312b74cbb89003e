#!/usr/bin/env bash
# drivers_test.sh PROGRAMS SCENES SHARED SCRATCH DRIVERS DEVICE_TESTS: pictures have the same bits on every version of Mesa's
# software driver. DRIVERS is a folder of folders that tools/unpack-debian made; pictures are compared with those of the
# first one in order. Renders every scene as it is, and some of them in each way that has arithmetic of its own. Then runs
# the device tests that some version has failed, or ended with a fault of its own. Exits with 77 (skipped) where there are
# fewer than two drivers.
set -eu
export LC_ALL=C.UTF-8
programs=$(realpath "$1") scenes=$(realpath "$2") shared=$(realpath -m "$3") scratch=$4 drivers=$(realpath -m "$5") device_tests=$(realpath "$6")
mapfile -t runs < <(ls "$drivers"/*/run 2>/dev/null)
if [ ${#runs[@]} -lt 2 ]; then
  echo "skipped: drivers_test.sh: needs two drivers in $drivers (tools/unpack-drivers)"
  exit 77
fi
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

# Where no device need keep denormal numbers: colours and coordinates around the least normal number, sums of which
# are denormal, and a scene of such a size.
sed 's/^\(amb\|dif\|spe\): .*/\1: 1e-39 1e-30 1e-20/' "$scenes/spheres.txt" >denormal-colours.txt
sed -e 's/^\(dif\|spe\): .*/\1: 1e-20 1e-35 1e-10/' -e 's/^amb: .*/amb: 0 0 0/' "$scenes/lights.txt" >denormal-products.txt
# The first line keeps the lights of a scene, its suns, where they are.
keep='/^light/ { isLight = 1 } /^(camera|plane|sphere|triangle)/ { isLight = 0 } isLight { print; next }'
scale='/^(pos|rad|v1|v2|v3):/ { $1 = $1; for (i = 2; i <= NF; ++i) $i *= s } { print }'
for size in 1e-12 1e-25 1e-38; do
  awk -v s="$size" -v OFMT=%.9g -v CONVFMT=%.9g "$scale" "$scenes/spheres.txt" >"size-$size.txt"
  awk -v s="$size" -v OFMT=%.9g -v CONVFMT=%.9g "$scale" "$scenes/light-behind.txt" >"size-$size-light-behind.txt"
  # Suns 10^38 times as far are too far for float32.
  [ "$size" = 1e-38 ] ||
    awk -v s="$size" -v OFMT=%.9g -v CONVFMT=%.9g "$keep $scale" "$scenes/spheres.txt" >"size-$size-suns.txt"
done

# A line is a render: a scene and options.
renders() {
  local scene
  for scene in "$scenes"/*.txt ./*.txt; do echo "$scene --width 300"; done
  if [ -d "$shared/course" ]; then
    for scene in "$shared"/course/scene*.txt; do echo "$scene --width 300"; done
  fi
  cat <<KINDS
$scenes/extensions.txt --width 200 --spp 16
$scenes/extensions.txt --width 150 --spp 8 --sampler random
$scenes/extensions.txt --width 100 --spp 2 --max-depth 60 --reflect 0.9
$scenes/showcase.txt --width 200 --spp 16 --filter gaussian
$scenes/spheres.txt --width 150 --spp 8 --filter blackman-harris
$scenes/torus.txt --width 150 --target-error 0.01
$scenes/extensions.txt --width 100 --target-error 0.02
$scenes/lights.txt --width 150 --light-radius 5 --reflect 0.3 --spp 4
$scenes/showcase.txt --width 200 --view normal
$scenes/showcase.txt --width 200 --view depth
$scenes/showcase.txt --width 200 --view shadow --spp 4
$scenes/thousand-spheres.txt --width 200 --view cost
KINDS
}

renders >renders
failures=0
reference=
for run in "${runs[@]}"; do
  name=$(basename "$(dirname "$run")")
  echo "$name: $("$run" "$programs/lavaray" --list-devices 2>&1)"
  mkdir "$name"
  count=0
  while read -r -a render; do
    count=$((count + 1))
    if ! "$run" "$programs/lavaray" -q "${render[@]}" -o "$name/$count.pfm"; then
      failures=$((failures + 1))
      echo "FAILED: $name: ${render[*]}"
    elif [ -n "$reference" ] && ! cmp -s "$reference/$count.pfm" "$name/$count.pfm"; then
      failures=$((failures + 1))
      echo "FAILED: not the bits of $reference on $name: ${render[*]}"
      "$programs/lavaray-diff" "$name/$count.pfm" "$reference/$count.pfm" || true
    fi
  done <renders
  if ! "$run" "$device_tests" --gtest_filter='*ManyLights*:Image.*:Traversal.*' >"$name/tests" 2>&1; then
    failures=$((failures + 1))
    echo "FAILED: $name: device tests"
    tail -n 20 "$name/tests"
  fi
  reference=${reference:-$name}
done
echo "figure: drivers: $count pictures on each of ${#runs[@]} drivers, $failures failures"
[ "$failures" -eq 0 ]
