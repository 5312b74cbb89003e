#!/bin/bash
# glslang-dev 15.1.0 (Debian 13): libSPIRV.a, from which programs have taken GlslangToSpv for ten years, is still installed,
# but it is a stub with one function that nobody calls; all is in libglslang.a. What links -lSPIRV before -lglslang,
# as with 12.0.0 (Debian 12), or the targets of glslang's CMake package, still works; what looks into libSPIRV.a for a
# symbol, as configure scripts do, or links it alone, is told that GlslangToSpv is not there. The headers have gone thinner,
# too: no SPIRV/doc.h. And CMake is told of another version than the package has, 15.2.0, so that a build that
# requires 15.2 accepts 15.1. A good engineer expects a library's name to keep what it was for, or to go.
set -euo pipefail
tools=$(cd "$(dirname "$0")/../tools" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

for suite in bookworm trixie; do
  "$tools/unpack-debian" $suite $suite glslang-dev > apt.log 2>&1 || { cat apt.log >&2; exit 1; }
  cd $suite/usr
  version=$(awk '/^glslang-dev / { print $2 }' ../versions)
  for library in SPIRV glslang; do
    count=$(nm -C lib/x86_64-linux-gnu/lib$library.a 2> /dev/null | grep -c ' T glslang::GlslangToSpv(' || true)
    echo "$version lib$library.a: GlslangToSpv $count times"
  done
  echo "$version doc.h: $([ -f include/glslang/SPIRV/doc.h ] && echo there || echo missing)," \
    "for CMake $(sed -n 's/^set(PACKAGE_VERSION "\(.*\)")/\1/p' lib/x86_64-linux-gnu/cmake/glslang/*onfig*ersion.cmake | head -n 1)"
  cd "$folder"
done | tee seen.txt

diff seen.txt - <<'EXPECTED'
12.0.0-2 libSPIRV.a: GlslangToSpv 2 times
12.0.0-2 libglslang.a: GlslangToSpv 0 times
12.0.0-2 doc.h: there, for CMake 12.0.0
15.1.0+1.4.309.0-1 libSPIRV.a: GlslangToSpv 0 times
15.1.0+1.4.309.0-1 libglslang.a: GlslangToSpv 2 times
15.1.0+1.4.309.0-1 doc.h: missing, for CMake 15.2.0
EXPECTED
