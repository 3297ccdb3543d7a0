#!/usr/bin/env bash
# Golden content checksums: a chain of short runs whose results must be the same, bit for bit, from
# every compiler, optimisation level and instruction set.
#
#   golden.sh check BIN        runs the chain with the programs in BIN; exit code 0: the checksums
#                              are those of checksums.txt, 1: they are not, 77: this processor lacks
#                              the instruction set that RUPTURE_ISA names
#   golden.sh regenerate BIN   replaces checksums.txt and keeps the old one as checksums.txt.old
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here
readonly golden=$here/checksums.txt skipped=77

# Writes the checkpoints and records that checksums.txt names into the current folder.
run_chain() {
  # The reference slider: equilibrium, 1000 steps, and a rupture that crosses it.
  "$bin/load" -q -o reference-equilibrium.h5
  "$bin/restart" reference-equilibrium.h5 -q -o reference-1000-steps.h5 --for 2e-4
  "$bin/load" -q --set driving.V=0.5 --until 6e-4 -o reference-rupture.h5 \
    --record reference-rupture-record.h5

  # A small one: a rupture, then rest, in which junctions are pinned again and slip slowly.
  "$bin/load" -q --config "$here/small.ini" --until 3e-4 -o rupture.h5
  "$bin/restart" rupture.h5 -q --set driving.V=0 --for 8e-4 -o rest.h5 \
    --record rest-record.h5 --record-every 2e-5

  # The other choices of the interface law, another seed, no damping, a driving point that returns.
  "$bin/restart" rupture.h5 -q --set driving.V=0 --set junctions.f_new=f_slip --for 8e-4 \
    -o no-slow-slip.h5
  "$bin/load" -q --config "$here/small.ini" --set junctions.slipping_times=exponential --seed 7 \
    --until 8e-4 -o exponential.h5
  "$bin/restart" rupture.h5 -q --set slider.damping=0 --set driving.V=-1 --for 8e-4 -o return.h5

  # The other interface laws: a rupture, then rest, in which springs slip slowly and are pinned.
  for law in simplified decaying; do
    "$bin/load" -q --config "$here/small.ini" --set "junctions.law=$law" --until 3e-4 -o "$law.h5"
    "$bin/restart" "$law.h5" -q --set driving.V=0 --for 4e-4 -o "$law-rest.h5"
  done

  # The event of Figure 3 from its shipped checkpoint: a rupture that crosses the slider fast, then
  # slowly, then fast again.
  "$bin/restart" "$here/../../checkpoints/fast-slow-fast.h5" -q --for 2.5e-3 -o event.h5 \
    --record event-record.h5
  # And the moment when it becomes slow, with the rows shared out among threads.
  for threads in 1 2 4 7; do
    "$bin/restart" event.h5 -q --threads "$threads" --for 4e-5 -o "event-$threads-threads.h5"
  done

  # A prepared interface: the event of its trigger region, alone and with threads.
  "$bin/prepare" -q --config "$here/small.ini" --set driving.V=0 --tau-bar 0.5 --sigma-bar 0.15 \
    --shape bell -o prepared.h5
  "$bin/restart" prepared.h5 -q --until-quiet 5e-4 -o prepared-event.h5 \
    --record prepared-event-record.h5 --record-every 2e-5
  "$bin/restart" prepared.h5 -q --threads 3 --until-quiet 5e-4 -o prepared-event-3-threads.h5

  # New forces in the junctions.
  "$bin/modify-phi" rest.h5 -q --shape bell --slipping pin --sigma-bar 0.1 -o bell.h5
  "$bin/restart" bell.h5 -q --set driving.V=1 --for 4e-4 -o bell-rupture.h5
}

# The chain's manifest, "<64 hex digits>  <file>" per line, after a look at every file.
manifest() {
  local file
  for file in *.h5; do printf '%s  %s\n' "$("$bin/analyze" checksum "$file")" "$file"; done
}

skip_without_instruction_set() {
  local said
  if said=$("$bin/load" -q -o probe.h5 2>&1); then
    rm probe.h5 probe.h5.sum
  elif [[ $said == *"no instruction set of this processor"* ]]; then
    echo "Skipped: ${said#load: }"
    exit "$skipped"
  fi
}

check() {
  local equal differing
  skip_without_instruction_set
  run_chain
  manifest >checksums.txt
  equal=$(comm -12 <(sort "$golden") <(sort checksums.txt) | wc -l)
  equal+=" of $(wc -l <"$golden") content checksums are equal"
  if diff "$golden" checksums.txt >differences; then
    echo "$equal."
  else
    differing=$(sed -n 's/^[<>] [0-9a-f]*  //p' differences | sort -u | paste -sd ' ')
    echo "Golden (<) and found (>):"
    cat differences
    echo "$equal, all but: $differing"
    exit 1
  fi
}

regenerate() {
  run_chain
  manifest >checksums.txt
  if [[ -e $golden ]]; then mv "$golden" "$golden.old"; fi
  cp checksums.txt "$golden"
  echo "Wrote $golden; the old one, if any, is beside it."
}

usage() {
  sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

if (($# != 2)) || [[ $1 != check && $1 != regenerate ]]; then usage; fi
bin=$(readlink -f "$2")
readonly bin
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$1"
