#!/usr/bin/env python3
"""Prints the rupture events of a load, measured in each way: measure_events.py PROGRAMS record.h5

{convention: events as `analyze events --json` lists them}; events/conventions.py has the names."""

import json
import sys

from events.conventions import WAYS, Analysis


def main(programs, record):
    found = Analysis(programs).each("events", record, WAYS)
    print(json.dumps({name: report["events"] for name, report in found.items()}))


if __name__ == "__main__":
    main(*sys.argv[1:])
