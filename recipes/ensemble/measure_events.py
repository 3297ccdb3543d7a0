#!/usr/bin/env python3
"""The rupture events of a load, measured in many ways: measure_events.py PROGRAMS RECORD [SETTING]

Prints {convention: events as `analyze events --json` lists them} (events/conventions.py); for the
claims on fronts of a SETTING {combination of conventions: {claim: held}} (events/product.py)."""

import json
import sys

from events.conventions import WAYS, Analysis
from events.product import claims_held, combinations


def main(programs, record, setting=None):
    found = Analysis(programs).each("events", record, combinations() if setting else WAYS)
    events = {name: report["events"] for name, report in found.items()}
    if setting:
        print(json.dumps({name: claims_held(setting, of) for name, of in events.items()}))
    else:
        print(json.dumps(events))


if __name__ == "__main__":
    main(*sys.argv[1:])
