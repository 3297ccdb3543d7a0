"""Draws a figure and judges its claims, from the points of its chains: -m chains.draw NAME"""

import sys
import time
from collections import Counter
from pathlib import Path

from chains.point import note
from chains.results import read_chains
from claims.claim import write_claims
from claims.judge import judge
from chains.script import module_at
from rupture.errors import Failure


def say_failed(name, points):
    """How many points failed, and why."""
    sentences = Counter(point.sentence for point in points if point.status != "done")
    for sentence, count in sentences.items():
        print(f"  {name}: {count} of {len(points)} points failed: {sentence}")


def make(recipe, chains, results):
    """Draws, and writes tables and claims.json. `chains`: {name: points} (results.py)."""
    numbers = module_at(f"recipes/{recipe}/figure.py").make(chains, results) or []
    write_claims(results / "claims.json", judge(recipe, chains), numbers)


def main(recipe):
    started, results = time.time(), Path("results", recipe)
    chains = read_chains(recipe)
    for name, points in chains.items():
        say_failed(name, points)
    script = f"recipes/{recipe}/figure.py"
    try:
        make(recipe, chains, results)
    except Failure as failure:
        sys.exit(f"{recipe}: {failure}")
    files = [path for path in results.glob("[!.]*") if path.stat().st_mtime >= started - 1]
    points = {one["path"]: None for row in chains.values() for p in row for one in p.lineage[:1]}
    note(
        sorted(files),
        f"{recipe}: draw, and judge the claims",
        recipe,
        f"figure.py of {script}",
        [script, *points],
        started,
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
