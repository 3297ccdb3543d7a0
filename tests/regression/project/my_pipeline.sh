#!/bin/sh
# A small prepared interface and its event. The tools are on the PATH, the folder is empty.
set -e
here=$(dirname "$0")
rupture prepare -q --config "$here/my_slider.ini" --tau-bar 0.5 --sigma-bar 0.15 -o start.h5
rupture restart start.h5 -q --for 2e-4 -o event.h5 --record event-record.h5
