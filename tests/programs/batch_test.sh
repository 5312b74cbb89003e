#!/usr/bin/env bash
# batch_test.sh PROGRAMS SCENES SCRATCH: several scenes in one process, and the scene from standard input.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"
programs=$1 scenes=$2 scratch=$3
lavaray=$programs/lavaray
rm -rf "$scratch" && mkdir -p "$scratch/other" && cd "$scratch" || exit 1

# Each picture of many scenes has the bits of its own run, whatever pipelines were there before: of few and many
# primitives, with and without mirrors, each of them twice.
small="--width 64"
names='spheres torus extensions lights fan star handout legacy facets light-behind'
list=
for name in $names; do
  cp "$scenes/$name.txt" .
  cp "$name.txt" "again-$name.txt"
  list="$list $name.txt"
done
cp "$scenes"/*.obj .
for name in $names; do list="$list again-$name.txt"; done
for mode in '' '--spp 6' '--target-error 0.05' '--view normal'; do
  expect 0 '' "$lavaray" $list $small $mode -q -o 'all-{}.pfm'
  for name in $names; do
    expect 0 '' "$lavaray" "$name.txt" $small $mode -q -o one.pfm
    for picture in "all-$name.pfm" "all-again-$name.pfm"; do
      holds "$mode: $picture has the bits of a run of its own" cmp one.pfm "$picture"
    done
  done
done

# Names of files
expect 0 '' "$lavaray" spheres.txt fan.txt $small
holds 'the default names are those of the scenes' test -s spheres.bmp -a -s fan.bmp
expect 0 '' "$lavaray" spheres.txt $small -o 'other/{}-{}.ppm'
holds '{} stands for the name of one scene, too' test -s other/spheres-spheres.ppm
expect 0 '' "$lavaray" spheres.txt fan.txt $small --json '{}.json' -q
for name in spheres fan; do
  holds "statistics of $name" python3 -c "import json; assert json.load(open('$name.json'))['scene']['file'] == '$name.txt'"
done
expect 2 '--output x.png would be the same for 2 scenes; it must have \{\}' "$lavaray" spheres.txt fan.txt -o x.png
expect 2 '--output - would be the same for 2 scenes' "$lavaray" spheres.txt fan.txt -o -
expect 2 '--json x.json would be the same for 2 scenes' "$lavaray" spheres.txt fan.txt --json x.json
for option in --watch --display '--checkpoint x.film' '--resume x.film'; do
  expect 2 "${option% *} is for one scene, here are 3 scenes" "$lavaray" spheres.txt fan.txt star.txt $option
done
cp spheres.txt other
expect 2 '--output of spheres.txt and of other/spheres.txt would both be spheres.bmp' "$lavaray" spheres.txt other/spheres.txt
expect 2 '--output of fan.txt and of fan.txt would both be fan.bmp' "$lavaray" fan.txt fan.txt
cp fan.txt xfan.ppm
expect 2 '--output xfan.ppm would replace the scene xfan.ppm, which is read' "$lavaray" fan.txt xfan.ppm -o 'x{}.ppm'
holds 'that scene is as it was' cmp fan.txt xfan.ppm

# One that fails is named, the others are rendered, and the first failure says the exit code.
printf '1\nsphere\npos: 0 0\n' >broken.txt
rm -f ./*.bmp
expect 3 '^lavaray: broken.txt:3: ' "$lavaray" spheres.txt broken.txt fan.txt $small
holds 'the others have their pictures' test -s spheres.bmp -a -s fan.bmp -a ! -e broken.bmp
mkdir -p busy/star.bmp
expect 5 'lavaray: star.txt: .*busy/star.bmp' "$lavaray" star.txt broken.txt fan.txt $small -o 'busy/{}.bmp'
holds 'both failures are named' grep -q '^lavaray: broken.txt:3: ' stderr
holds 'the last one has its picture' test -s busy/fan.bmp
expect 2 'lavaray: spheres.txt: --crop' "$lavaray" fan.txt spheres.txt $small --crop 60,0,64,48
expect 4 '^lavaray: --device no such names no device' "$lavaray" spheres.txt fan.txt --device 'no such'
expect 3 '^lavaray: broken.txt:3: ' "$lavaray" --check spheres.txt broken.txt fan.txt
holds '--check says what is in the others' test "$(grep -cE '^scene (spheres|fan).txt$' stderr)" = 2
expect 0 '^scene 2 of 2: fan.txt$' "$lavaray" -v spheres.txt fan.txt $small

# Progress is of all scenes, where they take long together.
expect 0 '^2 of 3: rendering +[3-6][0-9] %  0:[0-9]+ elapsed, 0:[0-9]+ left, [0-9.]+ spp$' \
  "$lavaray" spheres.txt fan.txt star.txt --width 200 --spp 64
holds 'at most a line for each tenth' test "$(grep -c ' of 3: ' stderr)" -le 10

# Samples are told of in the mean over the pixels in which something can show; a scene that fills a part of them.
expect 0 '' "$lavaray" handout.txt --width 200 --spp 8 --json handout.json -q
holds 'the mean is over pixels that are sampled' python3 - <<'END'
import json
s = json.load(open('handout.json'))
pixels = s['picture']['width'] * s['picture']['height'] - s['sampling']['skippedPixels']
assert s['sampling']['skippedPixels'] > 0 and s['sampling']['samplesPerPixel'] == 8
assert s['rays']['camera'] == 8 * pixels
END

# An interrupt ends the present scene with its picture, and the others are not begun.
"$lavaray" spheres.txt fan.txt star.txt --width 600 --spp 4000 -o 'interrupted-{}.ppm' 2>stderr &
render=$!
sleep 2
kill -INT $render
wait $render
code=$?
holds "an interrupt's exit code, $code" test $code = 130
holds 'the interrupted picture is named' grep -q '^lavaray: spheres.txt: interrupted at .* interrupted-spheres.ppm holds' stderr
holds 'those that are left are told of' grep -qx 'lavaray: interrupted; 2 scenes are left' stderr
holds 'they have no pictures' test -s interrupted-spheres.ppm -a ! -e interrupted-fan.ppm

# A picture that would take the place of a later scene's mesh.
cp torus.obj first.ppm
sed 's/torus\.obj/first.ppm/' torus.txt >later.txt
cp fan.txt first.txt
expect 2 '--output first.ppm would replace the mesh first.ppm' "$lavaray" first.txt later.txt $small -o '{}.ppm'
expect 2 '--json first.ppm would replace the mesh first.ppm' "$lavaray" first.txt later.txt --check --json '{}.ppm'
holds 'the mesh is as it was' cmp torus.obj first.ppm
holds 'nothing is begun' test ! -e later.ppm

# Standard input
expect 0 '' "$lavaray" torus.txt $small -o torus.ppm
expect 0 '' "$lavaray" - $small -o - <torus.txt
holds 'the picture of a file, its mesh from the current folder' cmp torus.ppm stdout
expect 0 '' bash -c "cat torus.txt | '$lavaray' - $small"
holds 'its name is stdin' test -s stdin.bmp
expect 0 '' "$lavaray" fan.txt - $small -o 'two-{}.ppm' <torus.txt
holds 'one of two' cmp torus.ppm two-stdin.ppm
expect 0 '^scene stdin$' "$lavaray" --check - <torus.txt
expect 0 '' "$lavaray" - $small -o part.film <torus.txt
expect 0 '' "$lavaray" torus.txt $small -o whole.ppm --resume part.film
holds 'a film of it is that of the same file' cmp torus.ppm whole.ppm
expect 2 '--output read.ppm would replace the scene' bash -c "cp torus.txt read.ppm; '$lavaray' - $small -o read.ppm <read.ppm"
holds 'a file that is read is not written' cmp torus.txt read.ppm
expect 3 '^lavaray: stdin:3: ' "$lavaray" - <broken.txt
expect 3 '^lavaray: stdin:3: ' "$lavaray" - fan.txt $small <broken.txt
expect 3 '^lavaray: stdin:1: the file is empty' "$lavaray" - </dev/null
expect 3 '^lavaray: stdin:2: a NUL byte' bash -c "printf '1\n\0' | '$lavaray' -"
expect 3 '^lavaray: stdin: cannot be read: Is a directory$' "$lavaray" - <.
expect 3 '^lavaray: stdin: cannot be read: it is closed' bash -c "'$lavaray' - <&-"
expect 2 'SCENE - is given 2 times' "$lavaray" - - <torus.txt
expect 2 '--watch needs scene files that may change' "$lavaray" --watch - <torus.txt
expect 2 'standard input, which is a terminal' python3 -c "
import os, pty, subprocess, sys
_, terminal = pty.openpty()
sys.exit(subprocess.run(['$lavaray', '-'], stdin=terminal).returncode)"
holds 'no temporary file is left' test -z "$(find . -name '.*.??????')"

echo "$checks checks, $failures failed"
[ $failures -eq 0 ]
