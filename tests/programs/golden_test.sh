#!/usr/bin/env bash
# golden_test.sh PROGRAMS SCENES GOLDEN SCRATCH NAME [LIMIT...]: renders a scene and compares it with its golden image,
# within lavaray-diff's LIMITs, by default bit for bit. On failure SCRATCH holds NAME-actual.png, NAME-expected.png and
# NAME-difference.png.
# With LAVARAY_UPDATE_GOLDEN=1 it makes the golden image instead.
set -eu
programs=$1 scenes=$2 golden=$3 scratch=$4 name=$5
shift 5
[ $# -gt 0 ] || set -- --tolerance 0
mkdir -p "$scratch"
actual=$scratch/$name-actual.png
expected=$scratch/$name-expected.png
"$programs/lavaray" "$scenes/$name.txt" --width 240 -o "$actual"
if [ "${LAVARAY_UPDATE_GOLDEN:-0}" = 1 ]; then
  cp "$actual" "$golden/$name.png"
  exit 0
fi
cp "$golden/$name.png" "$expected"
"$programs/lavaray-diff" "$@" -o "$scratch/$name-difference.png" "$actual" "$expected"
rm "$actual" "$expected" "$scratch/$name-difference.png"
