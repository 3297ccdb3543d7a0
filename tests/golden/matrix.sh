#!/usr/bin/env bash
# Builds the tools with one compiler at one optimisation level and checks the golden checksums.
#
#   matrix.sh SOURCE COMPILER LEVEL SCRATCH   e.g. matrix.sh . clang O0 /tmp/matrix
#
# Exit code 77: the compiler is missing.
set -euo pipefail

readonly source=$1 compiler=$2 level=$3 build=$4/$2-$3
readonly skipped=77
declare -Ar drivers=([gcc]=g++ [clang]=clang++) c_drivers=([gcc]=gcc [clang]=clang)

if ! command -v "${drivers[$compiler]}" >/dev/null; then
  echo "Skipped: ${drivers[$compiler]} is not installed."
  exit "$skipped"
fi

build_tools() {
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_C_COMPILER="${c_drivers[$compiler]}" -DCMAKE_CXX_COMPILER="${drivers[$compiler]}" \
    -DCMAKE_CXX_FLAGS="-$level" -DRUPTURE_KERNEL_FLAGS="-$level" -DRUPTURE_WERROR=OFF \
    -DRUPTURE_TESTS=OFF -DRUPTURE_BENCHMARKS=OFF || return
  cmake --build "$build" --parallel 1 --target tools
}

mkdir -p "$build"
if ! build_tools >"$build/log" 2>&1; then
  tail -n 40 "$build/log"
  echo "The build failed; its whole output is in $build/log."
  exit 1
fi
exec "$source/tests/golden/golden.sh" check "$build/bin"
