#!/usr/bin/env python3
"""Whether the claims on fronts hold for a load under each combination of conventions:
measure_product.py PROGRAMS SETTING record.h5

Prints {combination: {claim: held}}; events/product.py has the combinations and the claims."""

import json
import sys

from events.conventions import Analysis, words_of
from events.product import claims_held, combinations


def main(programs, setting, record):
    analyze = Analysis(programs)
    held = {
        name: claims_held(setting, analyze("events", record, words_of(options))["events"])
        for name, options in combinations().items()
    }
    print(json.dumps(held))


if __name__ == "__main__":
    main(*sys.argv[1:])
