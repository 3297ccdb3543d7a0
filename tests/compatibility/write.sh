#!/usr/bin/env bash
# Writes one file of each kind and interface law in a new folder, and their content checksums in its
# manifest, with the programs in the PATH: write.sh FOLDER
set -euo pipefail

slider=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/slider.ini
mkdir "$1"
cd "$1"
cp "$slider" .  # under its bare name, as its path would get into the provenance
for law in reference simplified decaying; do
  load -q --config slider.ini --set "junctions.law=$law" --until 3e-4 -o "$law.h5" \
    --record "$law-record.h5"
done
load -q --config slider.ini --until 3e-4 -o parts.h5 --record parts-record.h5 \
  --crossings 0.5 --fields 1e-4
load -q --config slider.ini --set junctions.law=simplified \
  --set junctions.delta_t_R=1e-4 --set junctions.mu_new=0.05 --until 3e-4 -o other-law.h5
prepare -q --config slider.ini --set driving.V=0 --tau-bar 0.5 --sigma-bar 0.15 \
  --x-trigger 0.006 -o prepared.h5
analyze checksum -- *.h5 >manifest
rm slider.ini
