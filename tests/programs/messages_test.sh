#!/usr/bin/env bash
# Every way in which the programs fail that can be brought about from outside: the exit code says what kind it is, and
# the message is for a user, without names from the source, the C++ library or Vulkan, and without numbers for reasons.
# Only where a Vulkan call fails does the name of its result stand behind the reason.
# Called with the folders of the programs, the scenes, the fuzzers' corpus and the shaders, and a scratch folder, which it
# makes anew.
set -u
programs=$1 scenes=$2 corpus=$3 shaders=$4 scratch=$5
lavaray=$programs/lavaray
diff=$programs/lavaray-diff
merge=$programs/lavaray-merge
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1
export LC_ALL=C
failures=0
messages=0

# Nothing of this is for a user. (json.exception, CImg and the like are libraries that the programs are made of.)
foreign='VK_|Vk[A-Z]|vk[A-Z]|std::|__|basic_string|_M_|what\(\)|vector::|bad_alloc|_Z[A-Z0-9]|0x[0-9a-f]{4}|CImg|cimg'
foreign="$foreign|CLI::|json\.exception|terminate called|libpng|[Ee]xception|[Aa]ssert|filesystem error|internal error"
foreign="$foreign|errno|Could not convert|[0-9]{40}|[0-9]\.[0-9]*000000"
# A reason that is a number only, or none.
foreign="$foreign|: *\(?-?[0-9]+\)?\$|^lavaray[a-z-]*: *\$"

complain() {
  failures=$((failures + 1))
  echo "FAILED: $1"
  cat stderr
}

# fails CODES COMMAND...: the command exits with one of CODES, separated by |, and says why in lines for a user.
fails() {
  local codes=$1 name
  shift
  timeout 60 "$@" >stdout 2>stderr  # none takes a second
  local actual=$?
  messages=$((messages + 1))
  [[ "$actual" =~ ^($codes)$ ]] || complain "$*: exit code $actual, expected $codes"
  # Nothing to say of success; a driver that ends the process is beyond the program.
  [[ "$actual" =~ ^(0|1[3-9][0-9])$ ]] && return
  name=$(grep -aoE '^lavaray(-diff|-merge)?: ' stderr | head -1)
  [ -n "$name" ] || complain "$*: no line that begins with the program's name"
  # But for what the user wrote, which is quoted.
  sed 's/"[^"]*"/""/g' stderr >unquoted
  [ "$actual" -eq 4 ] && sed -i -E 's/([a-z?]) \(VK_[A-Z_]+\)/\1/' unquoted
  if grep -aqE -- "$foreign" unquoted; then complain "$*: not in a user's words: $(grep -aoE -- "$foreign" unquoted)"; fi
  if grep -aq '[[:cntrl:]]' stderr; then complain "$*: control characters"; fi
  if grep -aqE '.{600}' stderr; then complain "$*: a line without end"; fi
}

scene=$scenes/spheres.txt

# Command lines
for options in '' '--bogus' "$scene extra -o x.png" "$scene extra --json x" \
  "$scene extra --watch" "$scene extra --resume x" "$scene $scene" '- -' '- --watch' '--width' "$scene -o" "$scene --device" "$scene --quiet=x"; do
  fails 2 "$lavaray" $options
done
for option in width height max-depth spp max-spp seed reflect light-radius target-error time-limit checkpoint-every; do
  for value in x -1 1e99 nan inf 99999999999999999999999 '' 1.5x; do
    fails 2 "$lavaray" "$scene" --checkpoint kept "--$option" "$value"
  done
done
for value in x 1 1,2 1,2,3,4,5 a,b,c,d -1,0,5,5 5,5,1,1 0,0,721,1 0,0,1,99999999999; do
  fails 2 "$lavaray" "$scene" --crop "$value"
done
for option in filter sampler view; do fails 2 "$lavaray" "$scene" --$option nonsense; done
for options in '--spp 4 --target-error 0.1' '--view error' '--view normal --target-error 0.1' '-q -v' \
  '--check --json x.json --width 1 --height 65536' '--sample-range 1:2' '--spp 4 --sample-range 3:2' '--spp 4 --sample-range x' \
  '--checkpoint-every 3' '-o picture.jpg' '-o .' '--watch -o -' '--view depth -o part.film' \
  '--normalize -o part.film' '--height 1 --width 65536' '--half' '--half -o a.png' '--layers depth' \
  '--layers depth -o -' '--layers x -o a.exr' '--layers depth,depth -o a.exr' '--layers , -o a.exr' '--layers' \
  '--layers error -o a.exr' '--layers depth -o a.exr --json a.depth.exr'; do
  fails 2 "$lavaray" "$scene" $options
done
for option in tolerance max-rmse max-flip max-differing; do
  for value in x -1 nan ''; do fails 2 "$diff" a.png b.png "--$option" "$value"; done
done
for options in '' 'a.png' '--info a.png b.png' 'a.png b.png -o x.jpg' '--bogus' 'a.png .' '. . -o x.png' 'a.png --from x.json'; do
  fails 2 "$diff" $options
done
for options in '' 'a.film' '-o a.png' 'a.film -o a.jpg' '--bogus' 'a.film -o a.png --crop 1,2' 'a.film -o a.png --half'; do
  fails 2 "$merge" $options
done

# Scenes and meshes, among them all that the fuzzers remember
long=$(printf 'x%.0s' {1..300})
ln -s endless.txt endless.txt
mkdir folder.txt folder.png
printf '\033[31m\007' >control
for file in no-such.txt no/such.txt folder.txt /dev/null endless.txt "$long.txt" "$(cat control).txt"; do
  fails 3 "$lavaray" "$file"
done
for file in "$corpus"/scene/*; do fails '0|3' "$lavaray" --check "$file"; done
head='2\ncamera\npos: 0 0 0\nfov: 60\nf: 100\na: 1\nmesh\nfile: %s\namb: 0 0 0\ndif: 0 0 0\nspe: 0 0 0\nshi: 1\n'
for file in "$corpus"/obj/* no-such.obj . "$long.obj" "$(cat control).obj"; do
  printf "$head" "$file" >mesh.txt
  fails '0|3' "$lavaray" --check mesh.txt
done

# Images
"$lavaray" "$scene" --width 16 -o good.png && "$lavaray" "$scene" --width 16 -o good.bmp &&
  "$lavaray" "$scene" --width 16 -o good.ppm && "$lavaray" "$scene" --width 16 -o good.pfm &&
  "$lavaray" "$scene" --width 16 -o good.exr || complain 'no images'
for format in png bmp ppm pfm exr; do
  printf 'not an image' >false.$format
  : >empty.$format
  head -c 60 good.$format >cut.$format
  for file in no-such.$format false.$format empty.$format; do
    fails 3 "$diff" $file $file
    fails 3 "$diff" --info $file
  done
  fails 3 "$diff" cut.$format cut.$format
  head -c -1 good.$format >short.$format
  fails 3 "$diff" short.$format good.$format
  fails 0 "$diff" good.$format good.$format
done
printf 'P6\n1000000 1000000\n255\n' >huge.ppm
printf 'PF\n-5 100000\n-1\n' >huge.pfm
printf 'P6\n99999999999999999999 1\n255\n' >endless.ppm
for file in "$corpus"/image/*; do fails '0|3' "$diff" --info "$file"; done
for file in folder.png huge.ppm huge.pfm endless.ppm "$scene"; do fails 3 "$diff" "$file" "$file"; done

# Films
"$lavaray" "$scene" --width 16 -o part.film && "$lavaray" "$scene" --width 16 --spp 8 -o other.film ||
  complain 'no films'
head -c 100 part.film >cut.film
sed 's/spheres/sphores/' part.film >changed.film
for files in no-such.film cut.film "$scene" folder.txt 'part.film part.film' 'part.film other.film' /dev/null; do
  fails 3 "$merge" $files -o merged.png
done
fails '0|3' "$merge" changed.film -o merged.png
fails 2 "$merge" part.film -o merged.png --crop 0,0,999,999
for file in no-such.film cut.film "$scene" other.film /dev/null; do
  fails 3 "$lavaray" "$scene" --width 16 --resume $file
done

# Shaders
mkdir shaders
fails 3 "$lavaray" "$scene" --shaders no-such-folder
fails 3 "$lavaray" "$scene" --shaders shaders
fails 3 "$lavaray" "$scene" --shaders "$scene"

# Outputs
ln -s endless.png endless.png
mkdir folder.bmp
for file in no-such-folder/a.png folder.bmp endless.png "$long.png" /proc/a.png; do
  fails 5 "$lavaray" "$scene" --width 16 -o "$file"
  fails 5 "$merge" part.film -o "$file"
  fails '5|10' "$diff" good.png good.bmp -o "$file"
done
fails 5 "$lavaray" "$scene" --width 16 --json no-such-folder/a.json
mkdir a.depth.exr
fails 5 "$lavaray" "$scene" --width 16 --layers depth -o a.exr
fails 5 "$lavaray" "$scene" --width 16 --checkpoint no-such-folder/a.film
for format in png bmp ppm pfm exr; do
  # What is too large is the file, or the memory of a driver that keeps it in one.
  fails '5|6' bash -c "ulimit -c 0; ulimit -f 1; '$lavaray' '$scene' --width 300 -o limited.$format"
done
fails 5 bash -c "'$lavaray' '$scene' -o - >/dev/full"
fails 5 bash -c "'$lavaray' '$scene' -o - >&-"
fails 5 bash -c "'$diff' good.png good.png >&-"

# Devices
no_driver='env VK_ICD_FILENAMES=/dev/null VK_DRIVER_FILES=/dev/null'
for options in '' '--list-devices' '--validate'; do fails 4 $no_driver "$lavaray" "$scene" $options; done
for device in 99 no-such 99999999999999999999 '*'; do fails 4 "$lavaray" "$scene" --device "$device"; done
fails 5 env -u DISPLAY "$lavaray" "$scene" --width 16 --display

# Too little memory, wherever it runs out. A sanitizer needs more than any limit leaves.
if bash -c "ulimit -v 1000000; '$lavaray' --version" >stdout 2>&1; then
  fails '4|6' bash -c "ulimit -v 600000; '$lavaray' '$scene' --width 60000 --spp 2 -o huge.ppm"
  fails '3|6' bash -c "ulimit -v 100000; '$diff' huge.ppm huge.ppm"
  # From a limit at which the program can hardly start to one at which it misses nothing but a driver: in between it is
  # the shaders' compiler that ends.
  cp -r "$shaders" whole-shaders
  compiler_ended=0
  for mebibytes in {20..300..4}; do
    bash -c "ulimit -v $((mebibytes * 1024)); '$lavaray' --version" >stdout 2>&1 || continue
    fails '1|3|4|6' bash -c "ulimit -v $((mebibytes * 1024)); $no_driver '$lavaray' '$scene' --shaders whole-shaders"
    grep -q 'the shader compiler ended in the middle' stderr && compiler_ended=1
    grep -q 'Vulkan driver' stderr && break
  done
  [ $compiler_ended -eq 1 ] || complain 'no limit at which the compiler ends'
  for mebibytes in {60..900..40}; do
    fails '0|1|4|6|1[3-9][0-9]' bash -c "ulimit -v $((mebibytes * 1024)); '$lavaray' -q '$scene' --width 1500 -o small.png"
  done
fi

echo "$messages messages and more, $failures failed"
[ $failures -eq 0 ]
