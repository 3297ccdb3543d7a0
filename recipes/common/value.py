#!/usr/bin/env python3
"""Prints one value of a JSON file, for use in a command: value.py choice.json fast_slow_fast.t"""

import json
import sys


def main(path, name):
    with open(path, encoding="utf-8") as file:
        value = json.load(file)
    try:
        for key in name.split("."):
            value = value[int(key)] if isinstance(value, list) else value[key]
    except (KeyError, IndexError, TypeError, ValueError):
        sys.exit(f"value.py: {path} has no value '{name}'.")
    if value is None:
        sys.exit(f"value.py: '{name}' in {path} is null.")
    print(value if isinstance(value, str) else json.dumps(value))


if __name__ == "__main__":
    main(*sys.argv[1:])
