#!/usr/bin/env bash
# Runs bench_step once per instruction set that this processor has and prints one table: the best
# of five repetitions in microseconds of processor time, or of real time where files are written.
#
#   benchmarks/run.sh [BIN [OPTION...]]   BIN: folder of the programs, default build/release/bin;
#                                         OPTION: for bench_step, e.g. --benchmark_filter=step
set -euo pipefail

root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/..
readonly root
bin=${1:-$root/build/release/bin}
if (($#)); then shift; fi
if [[ ! -x $bin/bench_step ]]; then
  echo "run.sh: there is no $bin/bench_step: install libbenchmark-dev and build everything" >&2
  exit 1
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
available=()
for isa in sse2 avx2 avx512 baseline; do
  RUPTURE_ISA=$isa "$bin/bench_step" --benchmark_list_tests >/dev/null 2>&1 || continue
  echo "Measuring with $isa ..." >&2
  RUPTURE_ISA=$isa "$bin/bench_step" --benchmark_format=csv --benchmark_repetitions=5 \
    --benchmark_min_time=0.2 "$@" >"$scratch/$isa" 2>/dev/null
  available+=("$isa")
done

cd "$scratch"
awk -F, '
  FNR == 1 { sets[++n_sets] = FILENAME }
  /^"[a-z_\/]+",[0-9]/ {
    name = substr($1, 2, length($1) - 2)
    if (name ~ /_(mean|median|stddev|cv)$/) next
    time = sub("/real_time", "", name) ? $3 + 0 : $4 + 0
    if (!(name in seen)) { seen[name] = 1; names[++n_names] = name }
    if (!((name, FILENAME) in best) || time < best[name, FILENAME]) best[name, FILENAME] = time
  }
  END {
    printf "%-32s", "best of 5 [us]"
    for (s = 1; s <= n_sets; ++s) printf "%12s", sets[s]
    print ""
    for (i = 1; i <= n_names; ++i) {
      printf "%-32s", names[i]
      for (s = 1; s <= n_sets; ++s) printf "%12.2f", best[names[i], sets[s]]
      print ""
    }
  }' "${available[@]}"
