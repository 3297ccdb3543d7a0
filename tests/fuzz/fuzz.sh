#!/usr/bin/env bash
# Searches for inputs that break the reader: builds the fuzz targets with clang in FOLDER and runs
# each for SECONDS. New inputs are kept in FOLDER/found; one that breaks something, in FOLDER.
#
#   fuzz.sh SECONDS FOLDER [TARGET...]   default targets: reader content
#
# Exit code 0: nothing broke, 77: clang or its fuzzer is not installed (where CI is set, that is 1).
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here skipped=77 files=$here/../compatibility/schema-3

usage() {
  sed -n '5,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

demand_fuzzer() {
  local program='extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }'
  if clang++ -fsanitize=fuzzer,address -x c++ - -o /dev/null <<<"$program" 2>/dev/null; then return; fi
  echo "Skipped: clang++ or its fuzzer (libclang-rt-dev) is not installed."
  if [[ -n ${CI-} ]]; then exit 1; fi
  exit "$skipped"
}

build() {
  cmake -S "$here/../.." --preset fuzz -B "$folder" && cmake --build "$folder" --target fuzz_targets
}

# libhdf5 keeps memory until the process ends, which is no leak of ours.
run() {
  local found=$folder/found/$1 inputs=("$here/corpus/$1")
  if [[ $1 == reader ]]; then inputs+=("$files"); fi
  if [[ $1 == resealed ]]; then inputs=("$files"); fi
  mkdir -p "$found"
  echo "== $1"
  ASAN_OPTIONS=detect_leaks=0:${ASAN_OPTIONS-} "$folder/bin/fuzz_$1" -max_total_time="$seconds" \
    -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 -artifact_prefix="$folder/$1-" \
    "$found" "${inputs[@]}" >"$folder/$1.log" 2>&1 || { tail -n 40 "$folder/$1.log" && return 1; }
  grep -E '^(stat::number_of_executed_units|Done)' "$folder/$1.log"
}

(($# >= 2)) || usage
readonly seconds=$1 folder=$2
shift 2
(($# > 0)) || set -- reader content
demand_fuzzer
mkdir -p "$folder"
build >"$folder/log" 2>&1 || { tail -n 40 "$folder/log" && exit 1; }
for target; do run "$target"; done
