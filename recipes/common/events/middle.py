"""Prints the time in the middle of a front's slow stretch [s]: middle.py front.json"""

import sys

from data.records import report
from events.fronts import middle_of


def main(path):
    front = report(path)
    if front["slow"] is None:
        sys.exit(f"middle.py: the front in {path} has no slow stretch.")
    return f"{middle_of(front['slow']):.7f}"
