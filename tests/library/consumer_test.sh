#!/usr/bin/env bash
# consumer_test.sh BUILD SOURCE SCRATCH: installs a build into a folder, and uses the library there as another project
# does: the program in docs/library.md, in C++17 and C++20, and each header by itself.
set -u
build=$1 source=$2 scratch=$3
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1
prefix=$scratch/prefix
failures=0
checks=0

# holds WHAT COMMAND...: the command succeeds.
holds() {
  checks=$((checks + 1))
  "${@:2}" >log 2>&1 && return
  failures=$((failures + 1))
  echo "FAILED: $1"
  tail -n 30 log
}

holds 'cmake --install' cmake --install "$build" --prefix "$prefix"
awk '/^```cpp/ { inside = 1; next } /^```/ { inside = 0 } inside' "$source/docs/library.md" >program.cpp
holds 'the document has a program' grep -q 'int main' program.cpp

for standard in 17 20; do
  holds "it configures in C++$standard" cmake -S "$source/tests/library/consumer" -B "cxx$standard" -DPROGRAM="$PWD/program.cpp" \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_STANDARD="$standard" -DCMAKE_CXX_EXTENSIONS=OFF
  holds "it compiles in C++$standard" cmake --build "cxx$standard"
  mkdir "run$standard"
  holds "it runs in C++$standard" sh -c "cd run$standard && ../cxx$standard/consumer >printed"
  holds 'it says what it did' grep -qx '300 x 200 pixels, 16 samples each' "run$standard/printed"
  holds 'it reports progress' grep -q '%' "run$standard/printed"
done

# The same scene from a file, by the program.
cat >sphere.txt <<'SCENE'
4
camera
pos: 0 2 10
fov: 40
f: 500
a: 1.5
sphere
pos: 0 1 0
rad: 1
amb: 0.8 0.2 0.1
dif: 0.8 0.2 0.1
spe: 0.5 0.5 0.5
shi: 30
plane
nor: 0 1 0
pos: 0 0 0
amb: 0 0 0
dif: 0 0 0
spe: 0 0 0
shi: 0
light
pos: 5 9 6
amb: 0.2 0.2 0.2
dif: 1 1 1
spe: 1 1 1
rad: 0.5
SCENE
holds 'the program renders the scene' "$prefix/bin/lavaray" sphere.txt --width 300 --spp 16 -o sphere.png
for standard in 17 20; do
  holds 'both pictures are the same' "$prefix/bin/lavaray-diff" "run$standard/sphere.png" sphere.png
done

# The program of docs/shaders.md and its heat map, while that is edited.
mkdir own && cd own || exit 1
block() { awk -v fence="\`\`\`$1" '$0 == fence { inside = 1; next } /^```/ { inside = 0 } inside' "$source/docs/shaders.md"; }
# comes COMMAND...: it succeeds within 20 s.
comes() {
  for _ in $(seq 200); do
    "$@" && return
    sleep 0.1
  done
  false
}
block cpp >program.cpp
block glsl >heat.comp
holds 'the program of the shaders is in a few lines' test "$(wc -l <program.cpp)" -le 30
holds 'it configures' cmake -S "$source/tests/library/consumer" -B build -DPROGRAM="$PWD/program.cpp" -DCMAKE_PREFIX_PATH="$prefix"
holds 'it compiles' cmake --build build
build/consumer "$source/scenes/torus.txt" heat.comp heat.ppm 2>messages &
program=$!
holds 'it writes a heat map' comes test -f heat.ppm
cp heat.ppm first.ppm
holds 'the heat map has warm and cold pixels' sh -c "tail -c +16 first.ppm | od -An -v -tu1 -w3 | sort -u | wc -l | grep -qE '^([5-9]|..+)\$'"
sed 's/heat(float(tests)/nope(float(tests)/' heat.comp >edited && mv edited heat.comp
holds 'a mistake is reported with its line' comes grep -qE '^heat\.comp:15: .*nope' messages
holds 'and the program goes on' kill -0 "$program"
holds 'with the picture that there was' cmp heat.ppm first.ppm
sed 's/nope(float(tests)/1.0 - heat(float(tests)/' heat.comp >edited && mv edited heat.comp
holds 'the next change makes another picture' comes sh -c '! cmp -s heat.ppm first.ppm'
kill "$program"
wait "$program" 2>/dev/null
cp first.ppm "$scratch/heat.ppm"
cd ..

headers=$(cd "$prefix/include" && echo lavaray/*.h)
holds "at most eight headers: $headers" test "$(wc -w <<<"$headers")" -le 8
for header in $headers; do
  echo "#include <$header>" >alone.cpp
  holds "$header compiles by itself" c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -I "$prefix/include" -fsyntax-only alone.cpp
done
holds 'no header speaks of other libraries' \
  sh -c "! grep -nE '\b(Vk[A-Z]|vk[A-Z]|glm|CImg|CLI|nlohmann|Imf|png_)' $prefix/include/lavaray/*.h"
library=$(find "$prefix" -name 'liblavaray.so.*' -type f)
# Weak symbols are templates of the standard library, as in every library.
readelf --dyn-syms -W "$library" | awk '$5 == "GLOBAL" && $6 == "DEFAULT" && $7 != "UND" { print $4, $8 }' | c++filt >exported
holds 'it exports something' grep -q 'FUNC lavaray::v0::Renderer::render' exported
holds 'nothing else is exported' sh -c "! grep -vF lavaray::v0:: exported"
if command -v pkg-config >/dev/null; then
  pc=$(dirname "$(find "$prefix" -name lavaray.pc)")
  holds 'pkg-config finds it' sh -c "c++ -std=c++17 program.cpp -o by-pkg-config \
    \$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs lavaray)"
else
  echo 'skipped: pkg-config is missing'
fi

functions=$(grep -c '^FUNC' exported)
echo "figure: $(cat "$prefix"/include/lavaray/*.h | wc -l) lines of public headers, $functions functions exported," \
  "library of $(stat -c %s "$library") bytes"
echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
