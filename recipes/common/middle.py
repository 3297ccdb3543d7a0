#!/usr/bin/env python3
"""Prints the time in the middle of a front's slow stretch [s]: middle.py front.json"""

import sys

from common.records import report


def main(path):
    slow = report(path)["slow"]
    if slow is None:
        sys.exit(f"middle.py: the front in {path} has no slow stretch.")
    print(f"{(slow['t_from'] + slow['t_to']) / 2:.7f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
