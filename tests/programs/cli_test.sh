#!/usr/bin/env bash
# The command line as a user meets it: exit codes, messages, files. Called with the folder of the programs, the
# folder of the scenes and a scratch folder, which it makes anew. What depends on the driver is tried on a second one,
# too, where LAVARAY_TEST_DRIVER_RUN names the script `run` that tools/unpack-debian makes of one.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"
programs=$1 scenes=$2 scratch=$3
lavaray=$programs/lavaray
diff=$programs/lavaray-diff
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1

scene=$scenes/spheres.txt
small="--width 64"

# Usage: exit code 2
expect 2 'SCENE' "$lavaray"
expect 2 'help' "$lavaray" --no-such-option "$scene"
expect 2 '\.bmp, \.png, \.ppm, \.pfm' "$lavaray" "$scene" -o picture.jpg
expect 2 'width' "$lavaray" "$scene" --width 0
expect 2 'height' "$lavaray" "$scene" --height x
expect 2 'X0 < X1 <= 64' "$lavaray" "$scene" $small --crop 10,0,65,5
expect 2 'crop' "$lavaray" "$scene" --crop 1,2,3
expect 2 'max-depth' "$lavaray" "$scene" --max-depth -1
expect 2 '' "$lavaray" "$scene" -q -v
holds 'no file after a usage error' test -z "$(find . -name '*.bmp')"

# Help and version
expect 0 '' "$lavaray" --help
holds 'the help names the options' grep -q -- '--crop' stdout
expect 0 '' "$lavaray" --version
holds 'the version is printed' grep -qE '^lavaray [0-9]+\.[0-9]+\.[0-9]+$' stdout

# Scene errors: exit code 3, and the file that was there stays
printf 'precious' >kept.bmp
printf '1\nsphere\npos: 0 0\n' >broken.txt
expect 3 '^lavaray: broken\.txt:3: ' "$lavaray" broken.txt -o kept.bmp
expect 3 'missing\.txt: cannot be read' "$lavaray" missing.txt -o kept.bmp
printf '2\ncamera\npos: 0 0 0\nfov: 60\nf: 100\na: 1\nmesh\nfile: gone.obj\namb: 0 0 0\ndif: 0 0 0\nspe: 0 0 0\nshi: 1\n' >mesh.txt
expect 3 'mesh\.txt:8: .*gone\.obj' "$lavaray" mesh.txt -o kept.bmp
holds 'a scene error leaves the output alone' grep -qx 'precious' kept.bmp

# Devices: exit code 4
expect 4 '"VK_DRIVER_FILES" names "/dev/null"' env VK_ICD_FILENAMES=/dev/null VK_DRIVER_FILES=/dev/null "$lavaray" "$scene" -o kept.bmp
expect 4 'there are:' "$lavaray" "$scene" --device 99 -o kept.bmp
expect 4 'no device' "$lavaray" "$scene" --device 'no such' -o kept.bmp
expect 0 '^0: ' "$lavaray" --list-devices
holds 'a device error leaves the output alone' grep -qx 'precious' kept.bmp

# Output: exit code 5, before the work
expect 5 'cannot be written' "$lavaray" "$scene" -o no-such-folder/picture.bmp
mkdir folder.bmp
expect 5 'not an ordinary file' "$lavaray" "$scene" -o folder.bmp
# One block of 1024 bytes is too little for the picture; and for a driver that keeps its memory in a file, which Mesa 22
# does not.
for run in '' ${LAVARAY_TEST_DRIVER_RUN:-}; do
  $run "$lavaray" --list-devices 2>devices
  limited='5|6'
  grep -q 'Mesa 22' devices && limited=5
  for file in kept.bmp kept.png; do
    expect "$limited" "($file: cannot be written|the driver keeps its memory in a file, .* 1024 bytes)" \
      bash -c "ulimit -c 0; ulimit -f 1; exec $run '$lavaray' '$scene' $small -o $file"
  done
done
holds 'a write error leaves the output alone' grep -qx 'precious' kept.bmp
holds 'no temporary file is left' test -z "$(find . -name '.*.??????')"

# Pictures
expect 0 '' "$lavaray" "$scene" $small
holds 'the default name is the scene with .bmp in this folder' test -s spheres.bmp
for format in bmp png ppm pfm; do expect 0 '' "$lavaray" "$scene" $small -o picture.$format; done
expect 0 '' "$diff" picture.png picture.bmp
expect 0 '' "$diff" picture.ppm picture.bmp
expect 0 '' "$diff" picture.pfm picture.bmp
holds 'it says that floats are compared as bytes' grep -qE '^compared as +trunc\(255 c\): the floats c of IMAGE ' stdout
"$lavaray" "$scene" $small -o - >piped.ppm 2>stderr
holds '-o - writes the same PPM to stdout' cmp piped.ppm picture.ppm
holds 'nothing else is printed' test ! -s stderr
# Closed streams: no other file takes their place, be it the picture or a driver's memory.
for run in '' ${LAVARAY_TEST_DRIVER_RUN:-}; do
  expect 5 'stdout, which is closed' bash -c "exec $run '$lavaray' '$scene' $small -o - >&-"
  for closed in '2>&-' '>&-' '<&-' '<&- >&- 2>&-'; do
    expect 0 '' bash -c "exec $run '$lavaray' -v --stats '$scene' $small -o closed.ppm $closed"
    holds "with $closed the picture is the same" cmp closed.ppm picture.ppm
  done
done
for program in "$lavaray" "$diff" "$programs/lavaray-merge"; do
  expect 5 'stdout' bash -c "'$program' --help >&-"
  expect 5 'stdout' bash -c "'$program' --version >/dev/full"
done
expect 5 'stdout' bash -c "'$diff' picture.png picture.bmp >&-"
expect 0 '' "$lavaray" -q "$scene" $small -o quiet.png
holds '-q prints nothing' test ! -s stderr
expect 0 'device: ' "$lavaray" -v "$scene" $small -o verbose.png
expect 0 'SAH cost' "$lavaray" --stats "$scene" $small -o stats.png
expect 0 'spheres +[1-9]' "$lavaray" --check "$scene" -o unwritten.png
holds '--check writes no picture' test ! -e unwritten.png

# Statistics as JSON
expect 0 '' "$lavaray" "$scene" $small --spp 4 --json stats.json --stats -o stats.png
holds '--json writes JSON' python3 -m json.tool stats.json
# json_has TEXT EXPRESSION: what Python makes of the expression, in which s is the object, is true.
json_has() {
  holds "--json: $1" python3 -c "import json, sys; s = json.load(open('stats.json')); sys.exit(not ($1))"
}
json_has "set(s) == set('schema lavaray scene picture bvh rays sampling device memory steps seconds'.split())"
json_has "s['picture']['width'] == 64 and s['picture']['height'] == $(sed -n 2p <(head -c 20 picture.ppm) | cut -d' ' -f2)"
json_has "s['schema'] == 2 and s['scene']['spheres'] == $(grep -cx sphere "$scene")"
json_has "s['sampling'] == dict(stopped='finished', samplesPerPixel=4, mostSamplesPerPixel=4, skippedPixels=0, estimatedRmse=None)"
json_has "s['rays']['camera'] == $(awk '$1 == "camera" && $2 != "rays" { print $2 }' stderr) and s['rays']['mirror'] == 0"
json_has "s['rays']['shadow'] == $(awk '$1 == "shadow" && NF == 2 { print $2 }' stderr) > 0"
json_has "all(abs(s['rays']['perSecond'][kind] * s['device']['activity']['seconds'] - s['rays'][kind]) < 1 for kind in ('camera', 'mirror', 'shadow'))"
json_has "abs(sum(rate if kind != 'all' else -rate for kind, rate in s['rays']['perSecond'].items())) < 1 < s['rays']['perSecond']['all']"
json_has "abs(s['rays']['perSecond']['all'] / 1e6 - $(awk '$1 == "a" && $2 == "second" { print $3 }' stderr)) < 0.006"
json_has "s['bvh']['primitives'] > 0 and s['device']['name'] and s['memory']['peakBytes'] > 1e6"
json_has "s['device']['activity']['clock'] in ('device', 'host') and len(s['device']['activity']['firstDispatches']) == s['device']['dispatches']"
json_has "all(submitted <= begin + 1e-3 and begin <= end <= done + 1e-3 and waits <= done for submitted, begin, end, waits, done in s['device']['activity']['firstDispatches'])"
json_has "0 <= s['device']['activity']['deviceIdleSeconds'] < s['device']['activity']['seconds'] < s['seconds']"
expect 0 '' "$(dirname "${BASH_SOURCE[0]}")/../../tools/plot-activity" stats.json stats.svg
holds 'plot-activity draws each dispatch' python3 -c "import json, xml.dom.minidom as dom; boxes = dom.parse('stats.svg').getElementsByTagName('rect'); assert len(boxes) == 1 + 2 * json.load(open('stats.json'))['device']['dispatches']"
json_has "abs(sum(step['seconds'] for step in s['steps']) - s['seconds']) < 1e-6 < s['seconds']"
expect 0 '' "$lavaray" "$scene" $small --target-error 0.05 --json stats.json -o stats.png
json_has "0 < s['sampling']['estimatedRmse'] <= 0.05"
expect 0 '' "$lavaray" "$scene" $small --spp 4 --crop 10,5,30,20 --normalize --json stats.json -o stats.ppm
json_has "s['sampling']['samplesPerPixel'] == 4"
holds 'a stretched crop has its own size' grep -aqx '20 15' <(head -c 20 stats.ppm)
printf 'precious\n' >kept.json
expect 5 'cannot be written' "$lavaray" "$scene" $small --json no-such-folder/stats.json -o unwritten.png
holds 'no picture where the statistics cannot be written' test ! -e unwritten.png
expect 3 'no-such-scene' "$lavaray" no-such-scene.txt --json kept.json -o unwritten.png
holds 'a scene error leaves the statistics alone' grep -qx 'precious' kept.json
expect 0 '' "$lavaray" "$scene" --check --json stats.json --width 77
json_has "set(s) == set('schema lavaray scene picture'.split()) and s['picture']['width'] == 77"
expect 5 'cannot be written' "$lavaray" "$scene" --check --json no-such-folder/stats.json
expect 2 '--output ./one.ppm and --json one.ppm are the same file' "$lavaray" "$scene" -o ./one.ppm --json one.ppm

ln -s target.png link.png
printf 'old' >target.png
expect 0 '' "$lavaray" "$scene" $small -o link.png
holds 'a symbolic link stays one' test -L link.png
expect 0 '' "$diff" target.png picture.png
chmod 640 target.png
expect 0 '' "$lavaray" "$scene" $small -o target.png
holds 'a replaced file keeps its mode' test "$(stat -c %a target.png)" = 640

# Sizes, parts and stretching
expect 0 '' "$lavaray" "$scene" --height 40 -o height.ppm
holds '--height alone keeps the aspect' grep -aqE '^6[0-9] 40$' <(head -c 20 height.ppm)
expect 0 '' "$lavaray" "$scene" $small --crop 10,5,30,20 -o part.ppm
holds 'a crop has its own size' grep -aqx '20 15' <(head -c 20 part.ppm)
dark=$scenes/facets.txt
expect 0 '' "$lavaray" "$dark" $small -o dark.pfm
expect 0 '' "$lavaray" "$dark" $small --normalize -o stretched.pfm
expect 10 '' "$diff" part.ppm picture.ppm
holds 'images of different size differ, with both sizes' grep -q 'reference' stdout

# Sampling
expect 0 '' "$lavaray" "$scene" $small --spp 4 -o four.pfm
expect 0 '' "$lavaray" "$scene" $small --spp 4 --filter blackman-harris -o filtered.pfm
expect 10 '' "$diff" four.pfm filtered.pfm
expect 2 'box, tent, gaussian, blackman-harris' "$lavaray" "$scene" --filter mitchell
expect 2 '' "$lavaray" "$scene" --spp 0
expect 2 '' "$lavaray" "$scene" --spp 4 --target-error 0.1
expect 0 'estimated RMSE' "$lavaray" "$scene" $small --target-error 0.01 --stats -o target.pfm
expect 0 'stopped +maxSamples' "$lavaray" "$scene" $small --target-error 1e-6 --max-spp 8 --stats -o most.pfm
expect 0 'stopped +timeLimit' "$lavaray" "$scene" $small --spp 4000000 --time-limit 0.5 --stats -o limited.pfm
expect 0 '' "$lavaray" "$scene" $small --target-error 0.005 --view samples -o samples.png
expect 0 '' "$lavaray" "$scene" $small --target-error 0.005 --view error -o error.pfm
expect 2 'needs --target-error' "$lavaray" "$scene" $small --view error
for view in normal depth object shadow cost; do
  expect 0 '' "$lavaray" "$scene" $small --view $view -o view.pfm
  expect 10 '' "$diff" view.pfm picture.pfm
  expect 0 '' "$lavaray" "$scene" $small --view $view --spp 3 -o view.pfm
  expect 0 '' "$lavaray" "$scene" $small --view $view --spp 3 --crop 10,5,30,20 -o view-part.pfm
  python3 - view.pfm view-part.pfm <<'END' || { failures=$((failures + 1)); echo "FAILED: --view $view: a crop"; }
import sys
def rows(file):  # top to bottom
    _, size, _, data = open(file, 'rb').read().split(b'\n', 3)
    width, height = map(int, size.split())
    return [data[12 * width * y:][:12 * width] for y in reversed(range(height))]
whole, part = rows(sys.argv[1]), rows(sys.argv[2])
sys.exit(part != [row[12 * 10:12 * 30] for row in whole[5:20]])
END
  checks=$((checks + 1))
  expect 2 'color, samples and error' "$lavaray" "$scene" $small --view $view --target-error 0.1
done
expect 0 '' "$lavaray" "$scene" $small --view depth -o view.png
expect 0 '' "$diff" --info view.png
holds '--info says the view' grep -qE '^View +depth$' stdout
expect 2 'color, normal, depth, object, shadow, cost, samples, error' "$lavaray" "$scene" --view nothing
# Costs: a scale in the message and in the PNG's text, numbers in PFM, their false colours in pictures.
scale='white is [0-9.]+ nodes and primitives tested for a sample'
expect 0 "^cost: $scale\$" "$lavaray" "$scene" $small --view cost -o cost.pfm
most=$(sed -n 's/^cost: white is \([0-9.]*\) .*/\1/p' stderr)
expect 0 "^cost: white is $most " "$lavaray" "$scene" $small --view cost --crop 10,5,30,20 -o cost.png
expect 0 '' "$diff" --info cost.png
holds '--info says the scale' grep -qE "^Scale +$scale\$" stdout
expect 0 '' "$lavaray" -q "$scene" $small --view cost -o cost.ppm
holds '-q keeps the scale quiet' test ! -s stderr
printf '1\ncamera\npos: 0 0 0\nfov: 90\nf: 8\na: 1\n' >nothing.txt
expect 0 '^cost: no ray tests a node or a primitive$' "$lavaray" nothing.txt --view cost -o nothing.png
python3 - cost.pfm cost.ppm "$most" <<'END' || { failures=$((failures + 1)); echo 'FAILED: --view cost: numbers and their colours'; }
import struct, sys
pfm, ppm, most = open(sys.argv[1], 'rb').read(), open(sys.argv[2], 'rb').read(), float(sys.argv[3])
_, size, _, data = pfm.split(b'\n', 3)
width, height = map(int, size.split())
values = [value for (value,) in struct.iter_unpack('>f', data)]
counts = [value * most for value in values]
assert max(values) == 1 and values[::3] == values[1::3] == values[2::3]
assert all(abs(count - round(count)) < 1e-3 for count in counts) and len(set(counts)) > 3
rows = [counts[3 * width * y:3 * width * (y + 1):3] for y in reversed(range(height))]
pixels = list(struct.iter_unpack('3B', ppm[-3 * width * height:]))
lightness = {}
for count, (r, g, b) in zip(sum(rows, []), pixels):
    lightness.setdefault(round(count), set()).add(0.2126 * (r / 255) ** 2.2 + 0.7152 * (g / 255) ** 2.2 + 0.0722 * (b / 255) ** 2.2)
assert all(len(values) == 1 for values in lightness.values()), 'a count has one colour'
order = [lightness[count] for count in sorted(lightness)]
assert all(max(a) < min(b) for a, b in zip(order, order[1:])), 'the larger the lighter'
assert pixels[sum(rows, []).index(most)] == (255, 255, 255)
END
checks=$((checks + 1))
expect 0 '' "$lavaray" "$scene" $small --reflect 0.5 -o mirrored.pfm
expect 0 '' "$lavaray" "$scene" $small --reflect 0.5 --max-depth 0 -o unmirrored.pfm
expect 10 '' "$diff" mirrored.pfm unmirrored.pfm
expect 0 '' "$lavaray" "$scene" $small --spp 16 --light-radius 1 -o soft.pfm
expect 10 '' "$diff" soft.pfm four.pfm

# A spherical light where nothing is said about samples: to a target error, for the views of colours, and one line says so.
line='stdin: a light has a radius: using --target-error 0.01; --spp 1 is one sample per pixel'
expect 0 '' "$lavaray" - $small --light-radius 1 -o soft-default.pfm <"$scene"
holds 'the line says so' test "$(cat stderr)" = "$line"
expect 0 '' "$lavaray" "$scene" $small --light-radius 1 --target-error 0.01 -o soft.pfm
holds 'no line where it is asked for' test ! -s stderr
holds 'the picture is the one that the line names' cmp soft.pfm soft-default.pfm
expect 0 '' "$lavaray" "$scene" $small --light-radius 1 -q -o soft-default.pfm
holds 'no line for --quiet' test ! -s stderr
holds 'the same picture' cmp soft.pfm soft-default.pfm
for options in '--light-radius 1 --spp 1' '--light-radius 1 --view normal' '--light-radius 1 --view shadow' '--light-radius 0'; do
  expect 0 'camera  *3072 \(1.00 a pixel' "$lavaray" "$scene" --width 64 --height 48 $options --stats -o one.pfm
  holds "$options: no line" sh -c '! grep -q "is a sphere" stderr'
done

# The same bits with any number of threads and any vector width of a driver that runs on the CPU; without its
# cache, so that each width compiles the shader.
soft=$scenes/extensions.txt
for mode in '--spp 1' '--spp 21 --filter tent' '--spp 7 --sampler random' '--target-error 0.005'; do
  expect 0 '' "$lavaray" "$soft" $small $mode -o any-threads.pfm
  for threads in 0 1 2 5; do
    expect 0 '' env LP_NUM_THREADS=$threads "$lavaray" "$soft" $small $mode -o threads.pfm
    holds "$mode: the same bits with $threads threads" cmp any-threads.pfm threads.pfm
  done
done
widths='128 256'
if grep -q avx512f /proc/cpuinfo; then widths="$widths 512"; fi
for width in $widths; do
  expect 0 '' env LP_NATIVE_VECTOR_WIDTH=$width MESA_SHADER_CACHE_DISABLE=true \
    "$lavaray" "$soft" $small --target-error 0.005 -o width.pfm
  holds "the same bits with vectors of $width bits" cmp any-threads.pfm width.pfm
done

# lavaray-diff
expect 0 '' "$diff" picture.png picture.png
holds 'equal images have no error' grep -qE '^RMSE +0$' stdout
expect 10 '' "$diff" stretched.pfm dark.pfm -o difference.png
holds 'the difference is a picture' test -s difference.png
expect 0 '' "$diff" --max-rmse 1 stretched.pfm dark.pfm
expect 10 '' "$diff" --max-rmse 1e-9 stretched.pfm dark.pfm
expect 0 '' "$diff" --max-differing 1000000 stretched.pfm dark.pfm
expect 0 '' "$diff" --max-flip 1 stretched.pfm dark.pfm
expect 10 '' "$diff" --max-flip 1e-9 stretched.pfm dark.pfm
expect 10 '' "$diff" --max-flip 1 --max-rmse 1e-9 stretched.pfm dark.pfm
expect 10 '' "$diff" --max-flip 1 --tolerance 1 stretched.pfm dark.pfm
expect 0 '' "$diff" --max-flip 0 picture.pfm picture.png
holds 'FLIP takes floats as what 8 bits show of them' grep -qE '^mean FLIP +0$' stdout
expect 2 '' "$diff" picture.png
expect 3 'broken\.txt' "$diff" picture.png broken.txt
printf 'not a picture' >fake.png
expect 3 'fake\.png' "$diff" fake.png picture.png

# What an image says of itself
says() { grep -qE "^$1 +$2$" stdout; }
expect 0 '' "$lavaray" "$scene" $small --spp 4 --seed 7 --crop 10,5,30,20 -o said.png
expect 0 '' "$diff" --info said.png
for pair in 'format=PNG' 'size=20 x 15' 'Software=lavaray [0-9.]+' 'Scene=spheres.txt' \
  'Size=64 x [0-9]+, pixels 10,5 to 30,20' 'Samples per pixel=4' 'Seed=7' 'Device=.+' 'Seconds=[0-9.e-]+'; do
  holds "--info says $pair" says "${pair%%=*}" "${pair#*=}"
done
cp "$scene" "$(printf 'Gem\303\244lde.txt')"
expect 0 '' "$lavaray" Gem*lde.txt $small -o named.png
expect 0 '' "$diff" --info named.png
holds 'a name beyond ASCII is kept' says Scene Gem.*lde.txt
for format in bmp ppm pfm; do
  expect 0 '' "$diff" --info picture.$format
  holds "--info says $format" says format "$(echo $format | tr a-z A-Z)"
  holds "--info says its size" says size '64 x [0-9]+'
done
expect 2 'REFERENCE' "$diff" --info picture.png picture.bmp
expect 3 'fake\.png' "$diff" --info fake.png
expect 3 'absent\.png' "$diff" --info absent.png

# A render that is interrupted, once it has said how far it is, ends soon and writes what it has
"$lavaray" "$scenes/thousand-spheres.txt" --width 4000 -o interrupted.ppm 2>stderr &
render=$!
until grep -q ' % ' stderr || ! kill -0 $render; do sleep 0.05; done
kill -INT $render
started=$(date +%s%N)
wait $render
code=$?
elapsed=$((($(date +%s%N) - started) / 1000000))
checks=$((checks + 3))
[ $code -eq 130 ] || { failures=$((failures + 1)); echo "FAILED: interrupted: exit code $code"; }
grep -q 'interrupted at .* %; interrupted.ppm holds' stderr || { failures=$((failures + 1)); echo 'FAILED: no word of it'; }
[ -s interrupted.ppm ] || { failures=$((failures + 1)); echo 'FAILED: no picture'; }
echo "an interrupted render ended after $elapsed ms"

echo "$checks checks, $failures failed"
[ $failures -eq 0 ]
