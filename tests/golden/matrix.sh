#!/usr/bin/env bash
# Builds the programs that make states as a line of matrix.txt says and checks that they go on from
# the files of tests/compatibility and give the golden checksums. Another build's `analyze` reads them.
#
#   matrix.sh check BUILD FOLDER ANALYZE   builds in FOLDER/BUILD; exit code 0: the checksums are
#                                          equal, 1: they are not, 77: this machine lacks what the
#                                          build needs (where CI is set, as in GitHub Actions, that is
#                                          1, too)
#   matrix.sh table FOLDER                 prints how the last check of every build ended
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
source=$(dirname "$(dirname "$here")")
readonly here source skipped=77 programs=(load prepare restart modify-phi)

builds() { grep -v '^#' "$here/matrix.txt"; }

# --- one build -----------------------------------------------------------------------------

skip() {
  if [[ -n ${CI-} ]]; then
    echo "Not checked, as it must be where CI is set: $1"
    exit 1
  fi
  echo "Skipped: $1"
  exit "$skipped"
}

demand_programs() {
  local program
  for program; do
    command -v "$program" >/dev/null || skip "$program is not installed."
  done
}

demand_sysroot() {
  local said status=0
  said=$("$here/sysroot.sh" "$architecture" "${sysroot%/*}") || status=$?
  if ((status == skipped)); then skip "$said"; fi
  if ((status != 0)); then
    echo "$said"
    exit 1
  fi
}

# As fast as it can be compiled: the states come from the library, so the programs need no optimisation,
# and all files of a target are one.
build_programs() {
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None "$@" \
    -DCMAKE_CXX_FLAGS="$level" -DRUPTURE_KERNEL_FLAGS="$level" -DRUPTURE_PROGRAM_FLAGS=-O0 \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -DRUPTURE_WERROR=OFF -DRUPTURE_TESTS=OFF -DRUPTURE_BENCHMARKS=OFF || return
  cmake --build "$build" --parallel 1 --target "${programs[@]}"
}

build_or_stop() {
  if ! build_programs "$@" >"$build/log" 2>&1; then
    tail -n 40 "$build/log"
    echo "The build failed; its whole output is in $build/log."
    exit 1
  fi
}

# The last line is that of the goldens.
compare() {
  ln -sf "$analyze" "$1/analyze"
  "$source/tests/compatibility/compatibility.sh" check "$1"
  "${analyze%/*}/golden" check --tools "$1" --work "$build/golden" \
    "$here/checksums.txt" "$here/chain.sh"
}

check_native() {
  local c_compiler=${compiler/%clang++/clang}
  c_compiler=${c_compiler/%g++/gcc}
  demand_programs "$compiler"
  build_or_stop -DCMAKE_C_COMPILER="$c_compiler" -DCMAKE_CXX_COMPILER="$compiler"
  compare "$build/bin"
}

# For each program of another processor, a script that runs it.
emulate() {
  local program script
  mkdir -p "$build/emulated"
  for program in "${programs[@]}"; do
    script=$build/emulated/$program
    printf '#!/bin/bash\nexec %q -L %q %q "$@"\n' "$1" "$sysroot" "$build/bin/$program" >"$script"
    chmod +x "$script"
  done
}

check_cross() {
  local processor=${compiler%%-*}
  demand_programs "$compiler" "qemu-$processor"
  demand_sysroot
  build_or_stop --toolchain "$source/cmake/$processor.cmake" -DCMAKE_SYSROOT="$sysroot"
  emulate "qemu-$processor"
  compare "$build/emulated"
}

check() {
  local compiler level architecture build sysroot analyze
  read -r compiler level architecture < <(builds | sed -n "s/^$1  *//p") || usage
  build=$(realpath -m "$2/$1")
  analyze=$(realpath "$3")
  sysroot=$(realpath -m "$2/sysroot-$architecture")
  mkdir -p "$build"
  if [[ -z $architecture ]]; then check_native; else check_cross; fi | tee "$build/said"
}

# --- all builds ----------------------------------------------------------------------------

table() {
  local name compiler level architecture said
  echo "Golden checksums of every build:"
  while read -r name compiler level architecture; do
    said=$(tail -n 1 "$1/$name/said" 2>/dev/null) || said=
    printf '  %-11s %-25s %s\n' "$name" "$compiler $level" "${said:-Not checked.}"
  done < <(builds)
}

usage() {
  sed -n '5,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

case "${1-} $#" in
  "check 4" | "table 2") "$@" ;;
  *) usage ;;
esac
