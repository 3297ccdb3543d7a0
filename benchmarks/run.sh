#!/usr/bin/env bash
# Measures how fast rupture is, prints tables and writes benchmarks.json. `--help` says more.
set -euo pipefail
export LC_ALL=C

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(dirname "$here")
readonly here root

bin=
output=
rounds=3
min_time=0.1
repetitions=2
sizes='size/.*'
lammps_seconds=1

print_help() {
  cat <<'EOT'
Usage: benchmarks/run.sh [OPTION]...

Measures the time per step and its parts with every instruction set of this processor, the
equilibrium solve, checkpoints and records, larger sliders, more threads, and the bulk in LAMMPS if
that is installed. Prints tables with the targets beside the values and writes everything as JSON.
Takes about 3 minutes; leave the machine alone meanwhile. benchmarks/README.md explains the rows.

Options
  -o FILE     where the JSON goes (default: build/benchmarks.json)
  --bin DIR   use the program DIR/bench instead of building the preset release
  --quick     one round, shorter, without the largest sizes: about 40 s, for a first impression
  -h, --help  print this text

Environment: LMP, the LAMMPS program (default: lmp)
EOT
}

usage_error() {
  echo "run.sh: $1 (see --help)" >&2
  exit 2
}

while (($#)); do
  case $1 in
    -h | --help) print_help && exit 0 ;;
    -o) [[ -n ${2-} ]] || usage_error "-o needs a file"; output=$2; shift ;;
    --bin) [[ -d ${2-} ]] || usage_error "--bin needs a folder"; bin=$(realpath "$2"); shift ;;
    --quick) rounds=1 min_time=0.05 sizes='size/0.*' lammps_seconds=0.5 ;;
    *) usage_error "there is no option '$1'" ;;
  esac
  shift
done

# Runs a command silently; shows what it said if it fails.
quietly() {
  "$@" >"$scratch/said" 2>&1 </dev/null || {
    tail -n 40 "$scratch/said" >&2
    echo "run.sh: this failed: $*" >&2
    exit 1
  }
}

# Measures what matches FILTER with instruction set ISA; Google Benchmark's JSON goes to FILE.
measure() { # ISA FILE FILTER
  RUPTURE_ISA=$1 quietly "$bin/bench" --benchmark_filter="^($3)" \
    --benchmark_out="$2" --benchmark_out_format=json \
    --benchmark_repetitions="$repetitions" --benchmark_min_time="$min_time"
}

output=${output:-$root/build/benchmarks.json}
mkdir -p "$(dirname "$output")"
output=$(realpath "$output")
# The scratch folder stands beside the result: files are to be measured on a disk, and /tmp may be
# none.
scratch=$(mktemp -d "$(dirname "$output")/benchmarks.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
readonly output scratch

if [[ -z $bin ]]; then
  echo "Building ..." >&2
  cd "$root"
  quietly cmake --preset release
  if grep -q 'Google Benchmark is missing' "$scratch/said"; then
    echo "run.sh: Google Benchmark is missing (Debian package: libbenchmark-dev)" >&2
    exit 1
  fi
  quietly cmake --build --preset release --target bench
  bin=$root/build/release/bin
fi
[[ -x $bin/bench ]] || usage_error "there is no $bin/bench"

# Narrowest first.
available=()
for isa in sse2 avx2 avx512 baseline neon; do
  ! RUPTURE_ISA=$isa "$bin/bench" --benchmark_list_tests >/dev/null 2>&1 || available+=("$isa")
done
readonly widest=${available[-1]}

# Everything in turn, several times, so that a busy spell of the machine does not hit one row only.
export TMPDIR=$scratch
for ((r = 1; r <= rounds; ++r)); do
  for isa in "${available[@]}"; do
    echo "Round $r of $rounds: $isa ..." >&2
    measure "$isa" "$scratch/$r-$isa.json" 'step/|bulk/|junctions/|peak/'
  done
  REPETITIONS=2 SECONDS_EACH=$lammps_seconds "$here/lammps/run.sh" \
    >>"$scratch/lammps" 2>"$scratch/lammps-says" || true
  echo "Round $r of $rounds: equilibrium, files, sizes, threads ..." >&2
  measure "$widest" "$scratch/$r-once.json" 'once/|record/|memory/'
  repetitions=1 measure "$widest" "$scratch/$r-sizes.json" "$sizes"
done
grep -v '^Measuring' "$scratch/lammps-says" >&2 || true

python=/usr/bin/python3
[[ -x $python ]] || python=python3
"$python" "$here/report.py" "$output" "$scratch"/[0-9]*.json --lammps "$scratch/lammps"
