"""Makes the results of a recipe: make.py recipes/NAME/figure.py

The script's function make(data, results) draws, writes tables, and returns the claims."""

import sys
from importlib import import_module
from pathlib import Path

from claims.claim import write_claims
from claims.judge import in_order

RESULTS = Path("results")


def main(path):
    script = Path(path)
    sys.path.insert(0, str(script.parent))
    results = RESULTS / script.parent.name
    claims = import_module(script.stem).make(RESULTS / "data", results)
    write_claims(results / "claims.json", in_order(claims))


if __name__ == "__main__":
    main(*sys.argv[1:])
