#!/usr/bin/env bash
# Reproduces the figures of the paper: installs what is missing, builds, runs, prints the claims.
# `./reproduce.sh --help` says what it can do.
set -euo pipefail

script=$(readlink -f "${BASH_SOURCE[0]}")
root=$(dirname "$script")
readonly script root caller=$PWD
readonly logs=build/log

command_names=()
dry_run=0
plan=
cores=
from_scratch=0
profile=
programs=

print_help() {
  cat <<'EOF'
Usage: ./reproduce.sh COMMAND [OPTION]...

Commands
  fig3 (or another figure)  install what is missing, build, compute, draw, print the claims
  all                       the same for everything, and the report
  sweep FILE.ini            run the model for all values that the file lists, and write a table and
                            a picture (docs/sweeps.md)
  report                    write results/index.html: all figures and claims on one page
  test                      build and run the tests
  test-slurm                install SLURM, start it here and compute through it (two minutes)
  check                     look for faults in the sources and in their layout
  tidy                      look for more of them, with clang-tidy (some minutes)
  list                      list the figures and other recipes
  clean                     delete build/ and results/ (never checkpoints/)

Options
  --dry-run                 of a sweep: say how many points there are, and compute none
  --from-scratch            compute the checkpoints that the figures start from, too,
                            instead of using those in checkpoints/
  --profile NAME            where commands run: local (the default), slurm, or another folder of
                            recipes/profiles/, or the path of one (docs/cluster.md)
  --programs FOLDER         use the programs there instead of building them
  --cores N                 use N cores of this machine (default: all)
  -h, --help                print this text
EOF
}

# --- what there is -------------------------------------------------------------------------

# The figures, and recipes that belong to none.
recipe_names() {
  local rules
  for rules in recipes/*/rules.smk; do
    if [[ -e $rules ]]; then basename "$(dirname "$rules")"; fi
  done | sort -V
}

is_recipe() { [[ -n $1 && -e recipes/$1/rules.smk && $1 != */* ]]; }

# The first line of a recipe's README, without the hash marks.
title_of() { sed -n '1s/^#* *//p' "recipes/$1/README.md" 2>/dev/null || true; }

print_list() {
  local name
  for name in $(recipe_names); do
    printf '  %-10s %s\n' "$name" "$(title_of "$name")"
  done
  printf '  %-10s %s\n' all 'everything above' sweep 'a sweep of your own' report 'the page of all figures and claims' \
    test 'the tests' test-slurm 'the tests of SLURM' check 'faults and layout of the sources' \
    tidy 'more faults' list 'this list' clean 'delete build/ and results/'
}

# --- how it speaks -------------------------------------------------------------------------

die() {
  printf 'reproduce.sh: %s\n' "$1" >&2
  exit 1
}

usage_error() {
  printf 'reproduce.sh: %s There are:\n' "$1" >&2
  print_list >&2
  exit 2
}

option_error() {
  printf 'reproduce.sh: %s See --help.\n' "$1" >&2
  exit 2
}

# Runs a command with its output in a log file, and shows the end of it only if the command fails.
quietly() {
  local log=$logs/$1.log what=$2
  shift 2
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    die "$what failed; the whole output is in $root/$log."
  fi
}

duration() {
  if (($1 < 60)); then printf '%d s' "$1"; else printf '%d min %d s' $(($1 / 60)) $(($1 % 60)); fi
}

# --- the command line ----------------------------------------------------------------------

set_cores() {
  [[ $1 =~ ^[1-9][0-9]{0,3}$ ]] || option_error "--cores needs a whole number from 1, not '$1'."
  cores=$1
}

# A path as the caller meant it; everything here happens in the project's folder.
of_caller() { if [[ $1 == /* ]]; then echo "$1"; else echo "$caller/$1"; fi; }

set_profile() {
  profile=$1
  if [[ $1 == */* ]]; then profile=$(of_caller "$1"); else profile=$root/recipes/profiles/$1; fi
  [[ -n $1 && -e $profile/config.yaml ]] || option_error "--profile '$1' is none: $profile/config.yaml does not exist."
  profile=$(cd "$profile" && pwd)
}

# What keeps a profile for a cluster from working here.
check_profile() {
  [[ -e $profile/srun.ini ]] || return 0
  command -v srun >/dev/null ||
    die "the profile ${profile##*/} needs SLURM's srun, which is not on the PATH; use it where jobs are submitted."
  [[ ! ${SLURM_STEP_ID-} =~ ^[0-9]{1,6}$ ]] ||
    die "inside a step of a job (srun), further steps would wait for its cores for ever; use the usual profile here, or salloc or sbatch."
  "$(debian_or_path python3)" recipes/slurm/settings.py "$profile/srun.ini" || exit
}

set_programs() {
  programs=$(of_caller "$1")
  [[ -n $1 && -x $programs/load ]] || option_error "--programs '$1' is no folder with rupture's programs: $programs/load does not exist."
}

parse() {
  while (($#)); do
    case $1 in
      -h | --help) print_help && exit 0 ;;
      --dry-run) dry_run=1 ;;
      --from-scratch) from_scratch=1 ;;
      --profile=*) set_profile "${1#*=}" ;;
      --profile) set_profile "${2-}" && shift ;;
      --programs=*) set_programs "${1#*=}" ;;
      --programs) set_programs "${2-}" && shift ;;
      --cores=*) set_cores "${1#*=}" ;;
      --cores) set_cores "${2-}" && shift ;;
      -*) option_error "there is no option '$1'." ;;
      *) command_names+=("$1") ;;
    esac
    shift
  done
  [[ -n $cores ]] || cores=$(getconf _NPROCESSORS_ONLN)
  [[ -n $profile ]] || set_profile local
}

# One command, or several figures.
check_commands() {
  local name
  if ((${#command_names[@]} == 0)); then
    print_help >&2
    exit 2
  fi
  if [[ ${command_names[0]} == sweep ]]; then
    ((from_scratch == 0)) || option_error "--from-scratch is for figures; a sweep starts from what its file says."
    ((${#command_names[@]} == 2)) || option_error "'sweep' needs one file, as in ./reproduce.sh sweep my.ini."
    return
  fi
  ((dry_run == 0)) || option_error "--dry-run is for 'sweep' only."
  for name in "${command_names[@]}"; do
    is_recipe "$name" && continue
    [[ $name =~ ^(all|report|test|test-slurm|check|tidy|list|clean)$ ]] || usage_error "there is no figure or command '$name'."
    ((${#command_names[@]} == 1)) || usage_error "'$name' cannot be combined with other commands."
  done
}

# --- packages ------------------------------------------------------------------------------

# The packages for the given purposes (run, test, check).
packages_for() { awk -v purposes=" $* " 'index(purposes, " " $1 " ") { print $2 }' packages.txt; }

# Those of the packages that are not installed, nor provided by one that is: on arm64, g++ provides
# g++-aarch64-linux-gnu.
missing_of() {
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package} ${Provides}\n' "$@" 2>/dev/null |
      sed -n 's/^installed //p' | tr -s ' ,' '\n' | sort -u)
}

install_packages() {
  echo "Installing $# Debian packages (log: $logs/packages.log) ..."
  export DEBIAN_FRONTEND=noninteractive
  quietly packages "Installing packages" bash -c \
    'apt-get update && apt-get install -y --no-install-recommends "$@"' install "$@"
}

ensure_packages() {
  local wanted missing
  mapfile -t wanted < <(packages_for "$@")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is not a Debian system: what packages.txt names has to be installed already."
    return
  fi
  mapfile -t missing < <(missing_of "${wanted[@]}")
  ((${#missing[@]} > 0)) || return 0
  if ((EUID == 0)); then
    install_packages "${missing[@]}"
  else
    echo "Some Debian packages are missing. Install them with this command, then start again:" >&2
    echo "sudo apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
}

# --- building ------------------------------------------------------------------------------

has_target() { cmake --build --preset release --target help 2>/dev/null | grep -q "^$1:"; }

# The tools alone, or everything with its tests.
build() {
  local target=$1
  quietly configure "Configuring" cmake --preset release
  has_target "$target" || target=all
  if ! ninja -C build/release -n "$target" 2>/dev/null | grep -q 'no work to do'; then
    echo "Building (log: $logs/build.log) ..."
    quietly build "The build" cmake --build --preset release --parallel "$cores" --target "$target"
  fi
}

# --- commands ------------------------------------------------------------------------------

# Debian's program and its Python come first: another Python on the PATH may lack h5py.
debian_or_path() {
  if [[ -x /usr/bin/$1 ]]; then echo "/usr/bin/$1"; else command -v "$1"; fi
}

clean_environment() {
  unset PYTHONPATH PYTHONHOME
  [[ ! -x /usr/bin/snakemake ]] || export PYTHONNOUSERSITE=1
  export XDG_CACHE_HOME=$root/build/cache MPLCONFIGDIR=$root/build/cache/matplotlib
  mkdir -p "$MPLCONFIGDIR"
}

# A stale lock of Snakemake's own must not stop the next run: take_turn has locked the folder.
recipes() {
  local snakemake where
  snakemake=$(debian_or_path snakemake) || die "Snakemake 7 is needed; Debian's package is enough."
  if [[ -e $profile/srun.ini ]]; then
    where=(--config srun="$profile/srun.ini")
  else
    where=(--cores "$cores" --config)
  fi
  "$snakemake" "$@" --snakefile "$root/recipes/Snakefile" --directory "$root" --profile "$profile" \
    --nolock "${where[@]}" from_scratch="$from_scratch" \
    ${programs:+bin="$programs"} ${plan:+sweep="$plan"}
}

# A signal has to reach Snakemake and what it runs, too: they get a process group of their own (set -m),
# to which it is passed on.
computing=

stop_computing() {
  local code=$1
  trap '' INT TERM HUP
  if [[ -n $computing ]]; then
    kill -INT -- "-$computing" 2>/dev/null || true
    wait "$computing" || true
  fi
  exit "$code"
}

run_recipes() {
  local code=0
  set -m
  recipes "$@" </dev/null &
  computing=$!
  set +m
  wait "$computing" || code=$?
  computing=
  return "$code"
}

# Rules *_start, where they exist, make what decides about later steps: checkpoints that a figure
# starts from, or a coarse map that is to be refined; rules *_refine what follows from those. Run
# first, on their own, they let everything after them see what came out (recipes/Snakefile).
stage_rules_of() {
  local stage=$1 figure
  shift
  for figure; do
    if grep -qs "^rule ${figure}_$stage:" recipes/"$figure"/*.smk; then echo "${figure}_$stage"; fi
  done
}

# Files that are gone although what was made from them is not, as after an interrupted run.
# Snakemake would take the older results for finished.
gone_of() { recipes "$@" --summary | awk -F '\t' '$6 == "missing" && $7 == "no update" { print $1 }'; }

compute() {
  local stage rules gone
  for stage in start refine; do
    mapfile -t rules < <(stage_rules_of "$stage" "$@")
    if ((${#rules[@]} > 0)); then run_recipes "${rules[@]}" || return; fi
  done
  gone=$(gone_of "$@") || return
  mapfile -t gone <<<"$gone"
  run_recipes "$@" ${gone[0]:+"${gone[@]}"}
}

# For the report: which recipes, with how many cores, when, and for how long.
note_run() {
  local started=$1
  shift
  printf '{"recipes": "%s", "where": "%s", "started": %d, "seconds": %d}\n' \
    "$*" "$(where_it_runs)" "$started" $((EPOCHSECONDS - started)) >>results/runs.jsonl
}

show() {
  local figure python
  python=$(debian_or_path python3)
  for figure; do
    echo
    "$python" recipes/common/print_claims.py "results/$figure/claims.json"
    echo "Pictures and data: $root/results/$figure/"
  done
}

where_it_runs() {
  if [[ -e $profile/srun.ini ]]; then
    echo "as jobs of SLURM (profile ${profile##*/})"
  else
    echo "with $cores cores"
  fi
}

reproduce() {
  ensure_packages run
  [[ -n $programs ]] || build tools
  clean_environment
  check_profile
  echo "Computing $* $(where_it_runs) ..."
  local started=$EPOCHSECONDS
  compute "$@" || die "$* could not be completed; the message above says why (log: $logs/recipes.log)."
  note_run "$started" "$@"
  show "$@"
}

# --- a user's sweep ------------------------------------------------------------------------

sweep_step() {
  local step=$1
  shift
  PYTHONPATH=$root/recipes PYTHONDONTWRITEBYTECODE=1 \
    "$(debian_or_path python3)" "recipes/sweep/$step.py" "$@"
}

# Which points are to be computed, as Snakemake lists them.
pending_points() {
  local summary
  summary=$(recipes sweep --summary) || die "Snakemake could not plan the sweep; the message above says why."
  awk -F '\t' '$7 == "update pending"' <<<"$summary"
}

# The table is written even if points could not be computed: it says which, and why.
sweep() {
  local file tools=${programs:-build/release/bin}
  file=$(of_caller "$1")
  ensure_packages run
  [[ -n $programs ]] || build tools
  clean_environment
  check_profile
  plan=$(sweep_step plan "$file" "$tools" results) || exit
  if ((dry_run)); then
    local pending
    pending=$(pending_points) || exit
    sweep_step preview "$plan" "$tools" <<<"$pending"
  else
    run_recipes sweep || pending_points >/dev/null || exit
    sweep_step report "$plan" results
  fi
}

# --- the report, tests and checks ----------------------------------------------------------

write_report() {
  PYTHONPATH=$root/recipes PYTHONDONTWRITEBYTECODE=1 \
    "$(debian_or_path python3)" recipes/report/report.py
}

report() {
  ensure_packages run
  clean_environment
  write_report
}

say_done() { printf '\nDone in %s.\n' "$(duration "$SECONDS")"; }

run_tests() {
  rm -f "$logs/test.log"
  ensure_packages run test
  build all
  clean_environment
  local status=0
  ctest --preset release --parallel "$cores" --no-tests=error \
    --output-log "$root/$logs/test.log" || status=$?
  echo
  tests/golden/matrix.sh table build/release/matrix
  return "$status"
}

# Where SLURM cannot be installed, ctest says that this was skipped.
test_slurm() {
  rm -f "$logs/slurm.log"
  ensure_packages run
  (ensure_packages slurm) || echo "Going on without them."
  build tools
  clean_environment
  ctest --preset slurm --no-tests=error --output-log "$root/$logs/slurm.log"
}

check_format() {
  clang-format --version | grep -q 'version 14\.' ||
    die "The layout is defined by clang-format 14, which is not the one installed here."
  find include src tests benchmarks -type f \( -name '*.?pp' -o -name '*.h' \) -print0 |
    xargs -0 --no-run-if-empty clang-format --dry-run -Werror
}

# The compiler sees the headers of libraries; without them this takes seconds, not minutes.
check_with_cppcheck() {
  cppcheck --quiet -j "$cores" --std=c++20 --language=c++ --enable=warning,style,performance,portability \
    --inline-suppr --suppressions-list=.cppcheck --library=googletest --error-exitcode=1 \
    -I include -I src -I src/tools -I tests -I tests/tools include src tests benchmarks
}

# Of its error stream, the counts of what it found in the headers of libraries are left out.
check_with_clang_tidy() {
  ensure_packages run check
  quietly configure-check "Configuring" cmake --preset check
  find src -name '*.cpp' -print0 |
    xargs -0 -P "$cores" -n 1 clang-tidy -p build/check --quiet 2> >(grep -v ' warnings\? ' >&2)
}

check_sources() {
  ensure_packages run check
  check_format || die "clang-format would change the files above (clang-format -i FILE)."
  shellcheck reproduce.sh .ci/run src/tools/rupture-golden tests/*/*.sh tests/regression/project/*.sh ||
    die "shellcheck found the faults above."
  check_with_cppcheck || die "cppcheck found the faults above (.cppcheck has what it may not say)."
  echo "The sources are laid out as they should be, and no fault was found in them."
}

tidy_sources() {
  check_with_clang_tidy || die "clang-tidy found the faults above (.clang-tidy has what it may not say)."
  echo "clang-tidy found no fault in the sources."
}

clean() {
  rm -rf build results .snakemake
  echo "Deleted build/ and results/."
}

# Two runs in the same folder would overwrite each other's files.
take_turn() {
  mkdir -p "$logs"
  command -v flock >/dev/null || return 0
  exec 9>build/.lock
  flock --nonblock 9 || die "another ./reproduce.sh is running in this folder; wait until it is done."
}

main() {
  cd "$root"
  trap 'stop_computing 130' INT
  trap 'stop_computing 143' TERM
  trap 'stop_computing 129' HUP
  parse "$@"
  check_commands
  case ${command_names[0]} in
    list) print_list ;;
    sweep) take_turn && sweep "${command_names[1]}" ;;
    report) take_turn && report ;;
    test) take_turn && run_tests ;;
    test-slurm) take_turn && test_slurm ;;
    check) take_turn && check_sources ;;
    tidy) take_turn && tidy_sources ;;
    clean) take_turn && clean ;;
    all)
      take_turn
      mapfile -t command_names < <(recipe_names)
      ((${#command_names[@]} > 0)) || die "there are no recipes under recipes/."
      reproduce "${command_names[@]}"
      echo
      write_report
      say_done
      ;;
    *)
      take_turn
      reproduce "${command_names[@]}"
      say_done
      ;;
  esac
}

main "$@"
