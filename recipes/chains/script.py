"""Prints what a script finds, as JSON: -m chains.script SCRIPT.py WORD...

The script's function main(WORD...) returns it. A text is printed as it is."""

import json
import sys
from importlib import import_module
from pathlib import Path


def module_at(path):
    """Those beside it can be imported, too."""
    sys.path.insert(0, str(Path(path).parent))
    return import_module(Path(path).stem)


def main(path, *words):
    found = module_at(path).main(*words)
    if found is not None:
        print(found if isinstance(found, str) else json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
