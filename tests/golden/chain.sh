#!/usr/bin/env bash
# The pipeline whose content checksums are in checksums.txt: a chain of short runs whose results must
# be the same, bit for bit, from every compiler, optimisation level and instruction set.
# Exit code 77: this processor lacks the instruction set that RUPTURE_ISA names.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here skipped=77

if ! said=$(load --version 2>&1) && [[ $said == *"is not an instruction set"* ]]; then
  echo "Skipped: ${said#load: }"
  exit "$skipped"
fi

# The reference slider: equilibrium, 1000 steps, and a rupture that crosses it.
load -q -o reference-equilibrium.h5
restart reference-equilibrium.h5 -q -o reference-1000-steps.h5 --for 2e-4
load -q --set driving.V=0.5 --until 6e-4 -o reference-rupture.h5 \
  --record reference-rupture-record.h5

# A small one: a rupture, then rest, in which junctions are pinned again and slip slowly.
load -q --config "$here/small.ini" --until 3e-4 -o rupture.h5
restart rupture.h5 -q --set driving.V=0 --for 8e-4 -o rest.h5 \
  --record rest-record.h5 --record-every 2e-5

# The other choices of the interface law, another seed, no damping, a driving point that returns.
restart rupture.h5 -q --set driving.V=0 --set junctions.f_new=f_slip --for 8e-4 \
  -o no-slow-slip.h5
load -q --config "$here/small.ini" --set junctions.slipping_times=exponential --seed 7 \
  --until 8e-4 -o exponential.h5
restart rupture.h5 -q --set slider.damping=0 --set driving.V=-1 --for 8e-4 -o return.h5

# The event of Figure 3 from its shipped checkpoint: a rupture that crosses the slider fast, then
# slowly, then fast again.
restart "$here/../../checkpoints/second-slow.h5" -q --for 2.5e-3 -o event.h5 \
  --record event-record.h5
# And the moment when it becomes slow, with the rows shared out among threads.
for threads in 1 2 4 7; do
  restart event.h5 -q --threads "$threads" --for 4e-5 -o "event-$threads-threads.h5"
done

# A prepared interface: the event of its trigger region, alone and with threads.
prepare -q --config "$here/small.ini" --set driving.V=0 --tau-bar 0.5 --sigma-bar 0.15 \
  --shape bell -o prepared.h5
restart prepared.h5 -q --until-quiet 5e-4 -o prepared-event.h5 \
  --record prepared-event-record.h5 --record-every 2e-5
restart prepared.h5 -q --threads 3 --until-quiet 5e-4 -o prepared-event-3-threads.h5

# New forces in the junctions.
modify-phi rest.h5 -q --shape bell --slipping pin --sigma-bar 0.1 -o bell.h5
restart bell.h5 -q --set driving.V=1 --for 4e-4 -o bell-rupture.h5

# The other interface laws: a rupture, then rest, in which springs slip slowly and are pinned.
for law in simplified decaying distance; do
  load -q --config "$here/small.ini" --set "junctions.law=$law" --until 3e-4 -o "$law.h5"
  restart "$law.h5" -q --set driving.V=0 --for 4e-4 -o "$law-rest.h5"
done
