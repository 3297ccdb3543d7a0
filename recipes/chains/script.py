"""Prints what a script finds, as JSON: -m chains.script SCRIPT.py WORD...

The script's function main(WORD...) returns it. If a program refuses, so does the script."""

import json
import sys
from importlib import import_module
from pathlib import Path

from rupture.errors import Failure


def module_at(path):
    """Imports a script, which may import the ones beside it."""
    sys.path.insert(0, str(Path(path).parent))
    return import_module(Path(path).stem)


def main(path, *words):
    try:
        found = module_at(path).main(*words)
    except Failure as failure:  # of a program that it runs
        sys.exit(str(failure))
    if found is not None:
        print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
