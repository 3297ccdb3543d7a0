#!/usr/bin/env bash
# Unpacks what the tools are built with for another architecture, the libraries of packages.txt and
# all that they depend on: the sysroot of a cross compiler and an emulator. This machine's own
# packages stay as they are: apt works with a state of its own, and needs no root.
#
#   sysroot.sh ARCHITECTURE FOLDER   e.g. sysroot.sh arm64 build makes build/sysroot-arm64
#
# Exit code 77: apt cannot get the packages here.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
sysroot=$(realpath -m "$2")/sysroot-$1
readonly here sysroot architecture=$1 work=$sysroot.part log=$sysroot.log skipped=77

# Dir::State::status lists what is installed: nothing.
private_apt() {
  apt-get -y --no-install-recommends -o Dir::State="$work/apt" -o Dir::Cache="$work/apt" \
    -o Dir::State::status="$work/apt/status" -o Acquire::Languages=none \
    -o APT::Architecture="$architecture" -o APT::Architectures::="$architecture" "$@"
}

# A source of packages that does not answer need not matter: the second command decides.
download() {
  private_apt update || true
  private_apt install --download-only "$@"
}

unpack() {
  local package
  for package in "$work"/apt/archives/*.deb; do
    dpkg-deb -x "$package" "$work/root" || return
  done
  # Since Debian 13 no package has files in /lib, where programs look for their loader.
  [[ -e $work/root/lib ]] || ln -s usr/lib "$work/root/lib"
}

mkdir -p "$2"
exec 9>"$sysroot.lock" # two builds may want it at the same time
flock 9
mapfile -t packages < <(sed -n '/pybind11/d; s/#.*//; s/^build//p' "$here/../../packages.txt" | grep -oE '[a-z0-9-]+-dev')
if [[ $(cat "$sysroot/packages" 2>/dev/null) == "${packages[*]}" ]]; then exit 0; fi

if ! command -v apt-get >/dev/null || ! command -v dpkg-deb >/dev/null; then
  echo "this is not a Debian system, where there would be $architecture libraries to build with."
  exit "$skipped"
fi
rm -rf "$sysroot" "$work"
mkdir -p "$work/apt" "$work/root"
touch "$work/apt/status"
if ! download "${packages[@]}" >"$log" 2>&1 </dev/null; then
  echo "apt-get cannot download Debian's $architecture libraries here (see $log)."
  exit "$skipped"
fi
if ! unpack >>"$log" 2>&1; then
  echo "The $architecture libraries could not be unpacked (see $log)."
  exit 1
fi
echo "${packages[*]}" >"$work/root/packages"
mv "$work/root" "$sysroot"
rm -rf "$work"
