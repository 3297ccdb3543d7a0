#!/usr/bin/env bash
# Installs packages and builds programs, for ./reproduce.sh:
#
#   set-up.sh packages PURPOSE...               those that packages.txt names for these purposes
#   set-up.sh python COMMAND...                 those to begin a command where Python is missing
#   set-up.sh build CORES TARGET [PURPOSE...]   a target of the release build; first the packages that
#                                               it needs, and those for these purposes
#   set-up.sh configure PRESET
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
readonly logs=build/log
readonly patience=900  # [s] with another program that is installing packages

die() {
  printf 'reproduce.sh: %s\n' "$1" >&2
  exit 1
}

# Runs a command with its output in a log file, and shows the end of it only if the command fails.
quietly() {
  local log=$logs/$1.log what=$2
  shift 2
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    die "$what failed; the whole output is in $PWD/$log."
  fi
}

# --- packages ------------------------------------------------------------------------------

packages_for() {
  awk -v purposes=" $* " 'index(purposes, " " $1 " ") {
    gsub(/^[a-z]+ +| *#.*/, ""); printf "%s%s", comma, $0; comma = ", " }' packages.txt
}

satisfy() {
  apt-get -o DPkg::Lock::Timeout="$patience" satisfy --no-remove --no-install-recommends "$@"
}

# A simulation installs nothing only if nothing is missing. Until dpkg does something, that stays so.
is_satisfied() {
  local said known=$logs/satisfied
  [[ $known -nt /var/log/dpkg.log ]] || : >"$known"
  grep -qxF "$1" "$known" && return
  said=$(satisfy --simulate "$1" 2>/dev/null) && ! grep -q ^Inst <<<"$said" && echo "$1" >>"$known"
}

# apt-get waits for dpkg's lock when asked to, but not for that of the package lists.
update_lists() {
  local end=$((SECONDS + patience)) errors=$logs/apt-errors.log
  until LC_ALL=C apt-get update 2>"$errors"; do
    cat "$errors"
    grep -q 'Could not get lock' "$errors" && ((SECONDS < end)) || return 1
    sleep 2
  done
}

install_packages() { update_lists && satisfy -y "$1"; }

ensure_packages() {
  local wanted
  (($# > 0)) || return 0
  if ! command -v apt-get >/dev/null; then
    echo "This is not a Debian system: the packages in packages.txt must already be installed."
    return
  fi
  wanted=$(packages_for "$@")
  is_satisfied "$wanted" && return
  if ((EUID == 0)); then
    echo "Installing Debian packages (log: $logs/packages.log) ..."
    export DEBIAN_FRONTEND=noninteractive
    quietly packages "Installing packages" install_packages "$wanted"
  else
    echo "Some Debian packages are missing. Install them with this command, then start again:" >&2
    echo "sudo apt-get satisfy --no-remove --no-install-recommends '$wanted'" >&2
    exit 1
  fi
}

# All that the command needs.
ensure_python() {
  local words=" $* "
  words=${words/ test-slurm / slurm }
  ensure_packages build run "$words"  # other words are no purposes
}

# --- building ------------------------------------------------------------------------------

# The build of a folder that was copied or moved: it would compile the sources of the other folder.
belongs_elsewhere() {
  local home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "build/$1/CMakeCache.txt" 2>/dev/null) &&
    [[ ! $home -ef . ]]
}

# In CI a warning of the reference compiler is an error, too.
configure() {
  local fresh=()
  ! belongs_elsewhere "$1" || fresh=(--fresh)
  quietly "configure-$1" "Configuring" cmake --preset "$1" "${fresh[@]}" ${CI:+-DRUPTURE_WERROR=ON}
}

# Only if there is something to compile or to link.
say_building() {
  [[ -n ${said-} ]] || echo "Building (log: $logs/build.log) ..."
  said=yes
}

show_progress() {
  local line
  while IFS= read -r line; do
    [[ $line =~ ^\[[0-9]+/[0-9]+\]\ (Building|Linking) ]] && say_building
  done
  return 0
}

run_build() {
  local cores=$1 target=$2
  cmake --build --preset release --parallel "$cores" --target "$target" 2>&1 |
    tee "$logs/build.log" | show_progress
}

# If another file than the presets has changed, Ninja configures by itself.
build() {
  if belongs_elsewhere release || [[ ! build/release/build.ninja -nt CMakePresets.json ]]; then
    say_building
    configure release
  fi
  run_build "$@" || {
    tail -n 60 "$logs/build.log" >&2
    die "The build failed; the whole output is in $PWD/$logs/build.log."
  }
}

mkdir -p "$logs"
case $1 in
  packages) shift && ensure_packages "$@" ;;
  python) shift && ensure_python "$@" ;;
  configure) configure "$2" ;;
  build)
    shift
    ensure_packages build "${@:3}"
    build "$1" "$2"
    ;;
esac
