#!/usr/bin/env bash
# film_test.sh PROGRAMS SCENES WORK: checkpoints, resuming and merging, as a user does them. Whatever the cuts, the
# picture has the bits of one that was rendered at once.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/../support/checks.sh"
lavaray=$1/lavaray
merge=$1/lavaray-merge
scenes=$2
rm -rf "$3"
mkdir -p "$3"
cd "$3" || exit 1

# same WHAT FILE FILE
same() {
  checks=$((checks + 1))
  cmp -s "$2" "$3" || { failures=$((failures + 1)); echo "FAILED: $1: $2 and $3 differ"; }
}

scene=$scenes/extensions.txt
size='--width 150 --height 100'

# Stopped again and again, at other places each time, and gone on with.
small=$size
for mode in '--spp 1' '--spp 50' '--spp 33 --sampler random --filter tent' '--target-error 0.003'; do
  size=$small
  if [ "$mode" = '--spp 1' ]; then size='--width 1500 --height 1000'; fi
  rm -f kept.film
  expect 0 '' "$lavaray" "$scene" $size $mode -o whole.pfm
  expect 0 '' "$lavaray" "$scene" $size $mode --checkpoint kept.film --time-limit 0.03 -o cut.pfm
  stops=0
  for limit in 0.02 0.05 0.01 0.08; do
    expect 0 '' "$lavaray" "$scene" $size $mode --checkpoint kept.film --resume kept.film --time-limit $limit \
      --stats -o cut.pfm
    if grep -q 'stopped  *timeLimit' stderr; then stops=$((stops + 1)); fi
  done
  expect 0 '' "$lavaray" "$scene" $size $mode --checkpoint kept.film --resume kept.film -o resumed.pfm
  same "$mode, resumed after $stops more stops" whole.pfm resumed.pfm
  expect 0 'camera +0 ' "$lavaray" "$scene" $size $mode --resume kept.film --stats -o again.pfm
  same "$mode, all of it from the film" whole.pfm again.pfm
  echo "$mode: resumed after $stops stops"
done

# Interrupted, with checkpoints all the time; whichever moment it was, the film can be gone on from.
expect 0 '' "$lavaray" "$scene" --width 300 --spp 100 -o long.pfm
for delay in 0.2 0.4 0.6; do
  rm -f kept.film
  "$lavaray" "$scene" --width 300 --spp 100 --checkpoint kept.film --checkpoint-every 0 -o cut.pfm 2>stderr &
  render=$!
  sleep $delay
  kill -9 $render 2>kill.log
  wait $render 2>wait.log
  if [ -e kept.film ]; then
    expect 0 '' "$lavaray" "$scene" --width 300 --spp 100 --resume kept.film -o resumed.pfm
    same "killed after $delay s" long.pfm resumed.pfm
  fi
done

# What does not fit is refused, named, and nothing is written over.
cp resumed.pfm precious.pfm
expect 0 '' "$lavaray" "$scene" $size --spp 8 --checkpoint kept.film -o whole.pfm
expect 3 '--seed is 1 here and 0 there' "$lavaray" "$scene" $size --spp 8 --seed 1 --resume kept.film -o precious.pfm
expect 3 '--spp is 12 here and 8 there' "$lavaray" "$scene" $size --spp 12 --resume kept.film -o precious.pfm
expect 3 'the crop is 0,0 to 9,9 here' "$lavaray" "$scene" $size --spp 8 --crop 0,0,9,9 --resume kept.film -o precious.pfm
expect 3 'another picture: scene is' "$lavaray" "$scenes/spheres.txt" $size --spp 8 --resume kept.film -o precious.pfm
expect 3 'no-such.film: cannot be read' "$lavaray" "$scene" $size --spp 8 --resume no-such.film -o precious.pfm
cp "$scenes"/torus.* .
expect 0 '' "$lavaray" torus.txt $size --checkpoint torus.film -o torus.pfm
echo '# another' >>torus.obj
expect 3 'mesh torus.obj is' "$lavaray" torus.txt $size --resume torus.film -o precious.pfm
same 'a refused film' resumed.pfm precious.pfm
expect 5 'cannot be written' "$lavaray" "$scene" $size --spp 8 --checkpoint no-such-folder/kept.film -o whole.pfm
expect 2 'view depth' "$lavaray" "$scene" $size --view depth --checkpoint kept.film
expect 2 'multiples of 4' "$lavaray" "$scene" $size --spp 16 --sample-range 2:8 -o part.film
expect 2 'ending .film' "$lavaray" "$scene" $size --spp 16 --sample-range 0:8 -o part.png
expect 2 'is no range' "$lavaray" "$scene" $size --spp 16 --sample-range 8 -o part.film

# Parts by crop and by samples, 1 to 16 of them
expect 0 '' "$lavaray" "$scene" $size --spp 64 -o whole.pfm
for count in 1 2 7 16; do
  rm -f part-*.film
  for ((i = 0; i < count; ++i)); do
    expect 0 '' "$lavaray" "$scene" $size --spp 64 -o part-$i.film \
      --crop 0,$((100 * i / count)),150,$((100 * (i + 1) / count))
  done
  expect 0 '' "$merge" part-*.film -o merged.pfm
  same "$count parts by crop" whole.pfm merged.pfm
  rm -f part-*.film
  for ((i = 0; i < count; ++i)); do
    expect 0 '' "$lavaray" "$scene" $size --spp 64 -o part-$i.film \
      --sample-range $((16 * i / count * 4)):$((16 * (i + 1) / count * 4))
  done
  expect 0 '' "$merge" part-*.film -o merged.pfm
  same "$count parts by samples" whole.pfm merged.pfm
done
expect 3 'samples 0:4 are in no part' "$merge" part-?[!0]*.film part-[1-9].film -o merged.pfm
head -c 5000 part-3.film >part-x.film
expect 3 'part-x.film: the film is truncated' "$merge" part-x.film part-[!3x]*.film -o merged.pfm
same 'a failed merge' whole.pfm merged.pfm
expect 3 '' "$merge" --check part-1.film part-x.film part-none.film
checks=$((checks + 1))
grep -qx 'part-1.film: complete' stdout && grep -q 'part-x.film: the film is truncated' stdout &&
  grep -q 'part-none.film: cannot be read' stdout ||
  { failures=$((failures + 1)); echo 'FAILED: --check:'; cat stdout; }
for ending in bmp png ppm; do
  expect 0 '' "$lavaray" "$scene" $size --spp 64 --normalize -o whole.$ending
  rm -f part-x.film
  expect 0 '' "$merge" part-*.film --normalize -o merged.$ending
  expect 0 '' "$1/lavaray-diff" whole.$ending merged.$ending
done
expect 0 'not the bits of one render' bash -c "
  '$lavaray' '$scene' $size --target-error 0.01 --crop 0,0,150,40 -o top.film &&
  '$lavaray' '$scene' $size --target-error 0.01 --crop 0,40,150,100 -o bottom.film &&
  '$merge' top.film bottom.film -o adaptive.pfm"

echo "$checks checks, $failures failed"
[ $failures -eq 0 ]
