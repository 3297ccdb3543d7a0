#!/usr/bin/env python3
"""Whether the claims on fronts hold for a load under each combination of conventions:
measure_product.py PROGRAMS SETTING record.h5

Prints {combination: {claim: held}}; events/product.py has the combinations and the claims."""

import json
import sys

from events.conventions import Analysis
from events.product import claims_held, combinations


def main(programs, setting, record):
    found = Analysis(programs).each("events", record, combinations())
    held = {name: claims_held(setting, report["events"]) for name, report in found.items()}
    print(json.dumps(held))


if __name__ == "__main__":
    main(*sys.argv[1:])
