"""Draws a figure and judges its claims, from the points of its chains: -m chains.draw NAME"""

import sys
import time
from collections import Counter
from pathlib import Path

from chains.point import note
from chains.results import origin_lines, read_chains
from claims.claim import write_claims
from claims.judge import judge
from chains.script import module_at
from report.origin import Accounts, builds
from rupture.errors import Failure
from rupture.figures import made_by


def main(recipe):
    started, results = time.time(), Path("results", recipe)
    chains, script = read_chains(recipe), f"recipes/{recipe}/figure.py"
    for name, points in chains.items():
        failed = Counter(point.sentence for point in points if point.status != "done")
        for sentence, count in failed.items():
            print(f"  {name}: {count} of {len(points)} points failed: {sentence}")
    points = [point for row in chains.values() for point in row]
    own = [(point.lineage[0]["path"], point.results[0]) for point in points]
    made_by[:] = origin_lines(f"./reproduce.sh {recipe}", own)
    try:
        numbers = module_at(script).make(chains, results) or []
        made_with = builds(Path(), Accounts(Path()).files_behind(recipe, dict(own)))
        write_claims(results / "claims.json", judge(recipe, chains), numbers, made_with)
    except Failure as failure:
        sys.exit(f"{recipe}: {failure}")
    files = sorted(path for path in results.glob("[!.]*") if path.stat().st_mtime >= started - 1)
    inputs = [script, *dict(own)]
    described = f"{recipe}: draw, and judge the claims"
    note(files, described, recipe, f"figure.py of {script}", inputs, started)


if __name__ == "__main__":
    main(*sys.argv[1:])
