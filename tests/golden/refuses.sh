#!/usr/bin/env bash
# Demands that the project refuses to be configured with a flag, and says why.
#
#   refuses.sh SOURCE FLAG SCRATCH CMAKE_ARGUMENT...
set -euo pipefail

readonly source=$1 flag=$2 build=$3
shift 3

rm -rf "$build"
if said=$(cmake -S "$source" -B "$build" -G Ninja -DRUPTURE_TESTS=OFF -DRUPTURE_BENCHMARKS=OFF \
  "$@" 2>&1); then
  echo "It was configured with $flag."
  exit 1
fi
read -rd '' -a words <<<"$said" || true # cmake breaks the sentence into lines
readonly sentence="$flag changes floating-point results, so checkpoints would no longer be bit for bit the same on every machine: remove it from the compiler flags."
if [[ ${words[*]} != *"$sentence"* ]]; then
  printf '%s\n' "$said" "It did not say: $sentence"
  exit 1
fi
