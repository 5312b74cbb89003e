#!/usr/bin/env bash
# setup_test.sh TOOLS SCRATCH: tools/setup where there is no apt-get, by the programs that PATH has: silent where nothing
# is missing, and else a line with the packages' names in the system, which its package manager tells.
set -u
tools=$1 scratch=$2
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1
failures=0
checks=0

# Everything that PATH has but what is to be missing, in a folder of its own.
# programs_without FOLDER NAME...
programs_without() {
  local folder=$1 name
  mkdir "$folder"
  (IFS=:; find -L $PATH -maxdepth 1 -type f -perm -u+x -exec ln -sf -t "$folder" {} + 2>/dev/null)
  shift
  for name; do rm -f "$folder/$name"; done
}

# expect CODE TEXT FOLDER PURPOSE...: with these programs, setup ends so, and prints the text and nothing else.
expect() {
  local code=$1 text=$2 path=$3 printed actual
  printed=$(PATH=$path "$path/bash" "$tools/setup" "${@:4}" 2>&1)
  actual=$?
  checks=$((checks + 1))
  [ "$actual" -eq "$code" ] && [ "$printed" = "$text" ] && return
  failures=$((failures + 1))
  printf 'FAILED: in %s setup %s exits with %s and prints\n%s\nexpected is %s and\n%s\n' \
    "$path" "${*:4}" "$actual" "$printed" "$code" "$text"
}

managers="apt-get rpm pacman"
programs_without "$scratch/all" $managers
programs_without "$scratch/few" $managers ninja xdotool python3
programs_without "$scratch/no-compiler" $managers c++
# The package managers only tell which system this is; they are not called.
for system in fedora:rpm arch:pacman; do
  for programs in all few no-compiler; do
    cp -r "$programs" "${system%:*}-$programs"
    ln -s "$(command -v false)" "${system%:*}-$programs/${system#*:}"
  done
done

says() { echo "setup: missing are these packages, by their names in $1: $2"; }
expect 0 '' "$scratch/all" build test
expect 0 '' "$scratch/fedora-all" build test
expect 0 '' "$scratch/arch-all" build test
expect 1 "$(says Debian 'ninja-build')" "$scratch/few" build
expect 1 "$(says Debian 'ninja-build python3 xdotool')" "$scratch/few" build test
expect 1 "$(says Fedora 'ninja-build python3 xdotool')" "$scratch/fedora-few" build test
expect 1 "$(says 'Arch Linux' 'ninja python xdotool')" "$scratch/arch-few" build test
# Without a compiler no header or library can be found, and each package is named once.
expect 1 "$(says 'Arch Linux' 'gcc glslang spirv-tools spirv-headers vulkan-headers glm cimg libpng openexr cli11 nlohmann-json xxhash libx11 vulkan-icd-loader')" \
  "$scratch/arch-no-compiler" build
expect 2 'setup: unknown purpose tests, allowed are build, test, swiftshader, gallery, format, tidy, fuzz, package, package-test, slurm-test' \
  "$scratch/all" tests
expect 2 'setup: unknown purpose without a name, allowed are build, test, swiftshader, gallery, format, tidy, fuzz, package, package-test, slurm-test' \
  "$scratch/all"

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
