#!/usr/bin/env bash
# Reproduces the figures of the paper: installs what is missing, builds, runs, prints the claims.
# `./reproduce.sh --help` says what it can do. The commands are in recipes/reproduce/.
set -euo pipefail

# A stream that is closed would become the next file. Output that nobody can read fails.
[[ -e /proc/self/fd/0 ]] || exec 0>/dev/null
[[ -e /proc/self/fd/1 ]] || exec 1</dev/null
[[ -e /proc/self/fd/2 ]] || exec 2>/dev/null

root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")

[[ $root != *:* ]] || { # it would be two folders with modules
  echo "reproduce.sh: the name of the folder $root has a colon; rename it" >&2
  exit 1
}

# Debian's Python comes first: another one on the PATH may lack h5py.
python=/usr/bin/python3
[[ -x $python ]] || bash "$root/recipes/reproduce/set-up.sh" python "$@"
[[ -x $python ]] || python=$(command -v python3)

unset PYTHONHOME
# Debian's packages, not the user's own.
[[ ! -d /usr/lib/python3/dist-packages/h5py ]] || export PYTHONNOUSERSITE=1
export PYTHONPATH=$root/recipes:$root/python PYTHONDONTWRITEBYTECODE=1
exec "$python" -P "$root/recipes/reproduce/__main__.py" "$@"
