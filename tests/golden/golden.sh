#!/usr/bin/env bash
# golden.sh check|regenerate TOOLS FOLDER: runs chain.sh with the programs in TOOLS in FOLDER, which is
# emptied, and compares the content checksums of its files with checksums.txt, or writes that.
# Exit code 77: this processor cannot run it.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$3"
mkdir -p "$3"
cd "$3"
export LC_ALL=C  # the order of names
PATH=$2:$PATH "$here/chain.sh"
"$2/analyze" checksum ./*.h5 | sed 's|^\(.*\)  \./|content-sha256 \1  |' >found.txt
if [[ $1 == regenerate ]]; then
  cp found.txt "$here/checksums.txt"
elif ! diff "$here/checksums.txt" found.txt; then
  echo "The files are in $3. If the change is intended: target rupture_regenerate_goldens"
  exit 1
fi
