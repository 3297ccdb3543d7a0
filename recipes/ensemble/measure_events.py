#!/usr/bin/env python3
"""Prints the rupture events of a load, measured in each way: measure_events.py PROGRAMS record.h5

{convention: events as `analyze events --json` lists them}; events/conventions.py has the names."""

import json
import sys

from events.conventions import WAYS, Analysis, words_of


def main(programs, record):
    analyze = Analysis(programs)
    events = {
        name: analyze("events", record, words_of(options))["events"]
        for name, options in WAYS.items()
    }
    print(json.dumps(events))


if __name__ == "__main__":
    main(*sys.argv[1:])
