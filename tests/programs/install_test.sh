#!/usr/bin/env bash
# install_test.sh BUILD SOURCE SCRATCH: installs a build into a folder and uses what is there, from another folder.
set -u
build=$1 source=$2 scratch=$3
rm -rf "$scratch" && mkdir -p "$scratch/elsewhere" && cd "$scratch/elsewhere" || exit 1
prefix=$scratch/prefix
failures=0
checks=0

# holds WHAT COMMAND...: the command succeeds.
holds() {
  checks=$((checks + 1))
  "${@:2}" >log 2>&1 && return
  failures=$((failures + 1))
  echo "FAILED: $1"
  cat log
}

holds 'cmake --install' cmake --install "$build" --prefix "$prefix"
holds 'all shaders are installed' diff -r -x CMakeLists.txt "$source/shaders" "$prefix/share/lavaray/shaders"
holds 'all scenes are installed' diff -r -x '*.png' "$source/scenes" "$prefix/share/lavaray/scenes"
for program in lavaray lavaray-diff lavaray-merge; do
  holds "$program has its manual page" gzip -t "$prefix/share/man/man1/$program.1.gz"
  holds "$program has its completion" bash -n "$prefix/share/bash-completion/completions/$program"
done
holds 'README.md is installed' cmp "$source/README.md" "$prefix/share/doc/lavaray/README.md"
holds 'nothing else is installed' diff \
  <(printf '%s\n' bin bin/lavaray{,-diff,-merge} include include/lavaray share share/{bash-completion,doc,lavaray,man}) \
  <(cd "$prefix" && find . -mindepth 1 -maxdepth 2 ! -path './lib*' -printf '%P\n' | LC_ALL=C sort)

PATH=$prefix/bin:$PATH
holds 'an installed scene renders' lavaray "$prefix/share/lavaray/scenes/showcase.txt" --width 160 -o built-in.png
holds 'the installed shaders compile' \
  lavaray "$prefix/share/lavaray/scenes/showcase.txt" --width 160 -o installed.png --shaders "$prefix/share/lavaray/shaders"
holds 'they are those in the program' lavaray-diff built-in.png installed.png

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
