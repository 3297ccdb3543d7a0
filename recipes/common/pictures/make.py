"""Makes the results of a recipe: make.py recipes/NAME/figure.py

The script's function make(data, results) draws, writes tables, and returns claims and numbers.
`data` is the folder results/data; for a recipe of chains, {chain: points} (chains/results.py)."""

import sys
from pathlib import Path

from claims.claim import Number, write_claims
from claims.judge import table
from data.call import module_at

RESULTS = Path("results")


def main(path, data=RESULTS / "data"):
    results = RESULTS / Path(path).parent.name
    rows = module_at(path).make(data, results)
    numbers = [row for row in rows if isinstance(row, Number)]
    claims = [row for row in rows if not isinstance(row, Number)]
    claims.sort(key=lambda claim: list(table()).index(claim.id))
    write_claims(results / "claims.json", claims, numbers)


if __name__ == "__main__":
    main(*sys.argv[1:])
