#!/usr/bin/env bash
# Runs ./reproduce.sh fig3 and test on the last commit in a bare Debian of another release, and compares
# all checksums with those of this clone, in which ./reproduce.sh fig3 must have run:
#
#   packaging/try-debian.sh RELEASE    e.g. trixie; as root, with mmdebstrap
# shellcheck disable=SC2016  # apt-get and an inner shell expand some words
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."

die() {
  printf 'try-debian.sh: %s\n' "$1" >&2
  exit "${2-1}"
}

# With the mirror and the network settings of this machine's apt.
make_debian() {
  local mirror
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Label: Debian' 'Component: main' | sed -n 1p)
  apt-config dump | grep -E '^Acquire::(http|Check)' >"$work/apt.conf" || true
  mmdebstrap --quiet --variant=minbase --aptopt="$work/apt.conf" "$1" "$debian" ${mirror:+"$mirror"} ||
    die "mmdebstrap cannot make a Debian '$1'; the reason is above."
  cp /etc/hosts "$debian/etc/"
}

# What it mounts and starts ends with it, and nobody else sees it. The inner shell stays, as "init".
in_debian() {
  unshare --mount --pid --fork --kill-child sh -c '
    mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
      chroot "$0" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; exit' \
    "$debian" http_proxy="${http_proxy-}" "$@"
}

# Of the contents: files also have the date and the build.
sums_of() {
  (cd "$1" && grep -rhsoE --include='*.json' '"checksums": \{[^}]*\}' results/store) |
    grep -oE '"[^"]+\.h5": "[0-9a-f]{64}"' | sort
}

compare() {
  local theirs different
  theirs=$(sums_of "$debian/rupture")
  different=$(comm -13 <(sums_of .) - <<<"$theirs")
  echo "Checksums that differ here, of $(grep -c . <<<"$theirs"): ${different:-none}"
  [[ -n $theirs && -z $different ]]
}

(($# == 1)) || die "give one Debian release, as in packaging/try-debian.sh trixie" 2
if ((EUID != 0)) || ! command -v mmdebstrap >/dev/null; then die "this needs root and mmdebstrap."; fi
[[ -n $(sums_of .) ]] || die "nothing to compare with: run ./reproduce.sh fig3 first."

work=$(mktemp -d "${TMPDIR:-/var/tmp}/rupture-debian.XXXXXX")
readonly work debian=$work/debian
trap 'exit 130' INT TERM
trap '[[ ! -d $work ]] || echo "Files are kept in $work." >&2' EXIT
make_debian "$1"
git clone --quiet . "$debian/rupture"
status=0
for command in fig3 test; do
  in_debian /rupture/reproduce.sh "$command" </dev/null || status=1
done
compare || status=1
((status == 0)) && rm -rf --one-file-system "$work"
exit "$status"
