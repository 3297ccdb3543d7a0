#!/usr/bin/env bash
# Times the bulk of the slider in LAMMPS (time.in) on one core: the best of five repetitions, in
# microseconds of processor time per step, one JSON object per line and variant.
#
#   benchmarks/lammps/run.sh [--table]    --table: a table for people instead
#   environment: LMP          the LAMMPS program, default lmp
#                REPETITIONS  default 5
#                SECONDS_EACH about how long one repetition takes, default 2
set -euo pipefail
export LC_ALL=C

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here
lmp=${LMP:-lmp}
readonly repetitions=${REPETITIONS:-5} seconds_each=${SECONDS_EACH:-2}
readonly variants=(springs drag damping)
table=no
case $#:${1-} in
  0:) ;;
  1:--table) table=yes ;;
  *) echo "usage: run.sh [--table]" >&2; exit 2 ;;
esac

if ! command -v "$lmp" >/dev/null; then
  echo "LAMMPS is not installed (no program '$lmp'; Debian package: lammps): not measured." >&2
  exit 0
fi
lmp=$(realpath -s "$(command -v "$lmp")")
readonly lmp

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
# One process, one thread, no helper daemon; whatever MPI writes goes to the scratch folder.
export TMPDIR=$scratch OMP_NUM_THREADS=1 OMPI_MCA_ess_singleton_isolated=1

# Runs VARIANT for STEPS steps; prints microseconds of processor time per step.
time_steps() { # VARIANT STEPS
  "$lmp" -log none -nocite -in "$here/time.in" -var bulk "$here/bulk.in" \
    -var variant "$1" -var steps "$2" \
    </dev/null >screen 2>errors || return 1
  awk '
    /^Loop time of/ { per_step = $4 / $9 * 1e6 }
    /% CPU use/ { share = $1 / 100 }
    END { if (!(per_step > 0 && share > 0)) exit 1; printf "%.3f\n", per_step * share }' screen
}

steps=()
failed=no
for v in "${!variants[@]}"; do
  if us=$(time_steps "${variants[v]}" 2000); then
    steps[v]=$(awk -v us="$us" -v s="$seconds_each" 'BEGIN { print 1000 * int(s * 1e3 / us + 1) }')
  else
    echo "run.sh: LAMMPS could not run the variant ${variants[v]}:" >&2
    cat screen errors | grep -m 1 ERROR >&2 || true
    failed=yes
  fi
done

# In turn, so that a busy spell of the machine does not hit one variant only.
for ((r = 1; r <= repetitions; ++r)); do
  echo "Measuring LAMMPS, repetition $r of $repetitions ..." >&2
  for v in "${!steps[@]}"; do
    time_steps "${variants[v]}" "${steps[v]}" >>"times_${variants[v]}"
  done
done

version=$(sed -n '/^LAMMPS (/ { s/^LAMMPS (\(.*\))$/\1/p; q }' screen)
if [[ $table == yes ]]; then
  printf '%-20s%12s    LAMMPS %s\n' "best of $repetitions" "us per step" "$version"
fi
for v in "${!steps[@]}"; do
  best=$(sort -g "times_${variants[v]}" | head -n 1)
  if [[ $table == yes ]]; then
    printf '%-20s%12.2f\n' "lammps/${variants[v]}" "$best"
  else
    printf '{"name": "lammps/%s", "us_per_step": %.2f, "steps": %d, "repetitions": %d, ' \
      "${variants[v]}" "$best" "${steps[v]}" "$repetitions"
    printf '"version": "%s"}\n' "$version"
  fi
done
[[ $failed == no ]]
