#!/usr/bin/env python3
"""Says what a sweep would compute: preview.py PLAN.ini FOLDER_OF_TOOLS < FILES

FILES: lines of Snakemake's --summary, of the points that are to be computed."""

import sys
from pathlib import Path

from common.sweeps import read_sweep
from sweep.plural import plural


def main(plan, folder_of_tools):
    sweep = read_sweep(plan)
    missing = {Path(line.split("\t")[0]).stem for line in sys.stdin}
    to_compute = [point for point in sweep.points if point.id in missing]
    there = len(sweep.points) - len(to_compute)
    count = plural(len(sweep.points), "point")
    print(f"{sweep.title}: {count}, {there} there, {len(to_compute)} to compute.")
    if to_compute:
        print("The first of these (its files are deleted afterwards):")
        for command in to_compute[0].commands.values():
            print(f"  {folder_of_tools}/{command}")


if __name__ == "__main__":
    main(*sys.argv[1:])
