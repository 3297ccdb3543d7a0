#!/usr/bin/env bash
# Files of every schema version that there was, which must stay readable for ever.
#
#   compatibility.sh check BIN          the programs in BIN verify the files in schema-*/, go on from the
#                                       checkpoints and analyse the records; exit code 0: all of them
#   compatibility.sh write BIN FOLDER   writes one file of each kind and interface law, and their
#                                       content checksums in FOLDER/manifest
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here

write() {
  local law
  cp "$here/slider.ini" .
  for law in reference simplified decaying; do
    load -q --sum --config slider.ini --set "junctions.law=$law" --until 3e-4 -o "$law.h5" \
      --record "$law-record.h5"
  done
  load -q --sum --config slider.ini --until 3e-4 -o parts.h5 --record parts-record.h5 \
    --crossings 0.5 --fields 1e-4
  load -q --sum --config slider.ini --set junctions.law=simplified \
    --set junctions.delta_t_R=1e-4 --set junctions.mu_new=0.05 --until 3e-4 -o other-law.h5
  prepare -q --sum --config slider.ini --set driving.V=0 --tau-bar 0.5 --sigma-bar 0.15 \
    --x-trigger 0.006 -o prepared.h5
  rm slider.ini
  cat ./*.h5.sum >manifest
  rm ./*.h5.sum
}

go_on() {
  restart "$1" -q -f --for 2e-5 -o next.h5
  analyze verify next.h5 >/dev/null
  analyze stress "$1" >/dev/null
}

look_at() {
  analyze events "$1" >/dev/null
  analyze loading "$1" >/dev/null
}

check() {
  local manifest line name count=0
  for manifest in "$here"/schema-*/manifest; do
    analyze verify --manifest "$manifest" >/dev/null
    while read -r line; do
      name=${line##* }
      case $name in
        *record.h5) look_at "${manifest%/*}/$name" ;;
        *) go_on "${manifest%/*}/$name" ;;
      esac
      count=$((count + 1))
    done <"$manifest"
  done
  echo "$count files of all versions are read as they were written."
}

usage() {
  sed -n '5,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

case "${1-} $#" in
  "check 2") folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT ;;
  "write 3") mkdir -p "$3" && folder=$3 ;;
  *) usage ;;
esac
# By name, so that no path gets into the provenance of what they write.
PATH=$(readlink -f "$2"):$PATH
cd "$folder"
"$1"
