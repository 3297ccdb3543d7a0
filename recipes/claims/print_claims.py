#!/usr/bin/env python3
"""Prints claims as a table that fits into 100 columns: print_claims.py results/fig3/claims.json"""

import json
import signal
import sys
import textwrap
from pathlib import Path

from claims.claim import NOT_COMPARABLE, VERDICTS, measured_parts, read_claims

SUMMARY = "summary.txt"  # what a recipe has to say beyond claims, beside its claims.json
WIDTH = 100
GAP = "  "
HEADS = ("claim", "paper", "measured", "acceptance", "verdict")


def measured_text(measured):
    return "; ".join(measured_parts(measured))


def widths(rows):
    """The first and last column as wide as they must be; the others share the rest."""
    first = max(len(row[0]) for row in rows)
    last = len(NOT_COMPARABLE)
    rest = WIDTH - first - last - 4 * len(GAP)
    return first, rest // 3, rest - 2 * (rest // 3), rest // 3, last


def print_row(cells, columns):
    wrapped = [textwrap.wrap(cell, width) or [""] for cell, width in zip(cells, columns)]
    for line in range(max(map(len, wrapped))):
        parts = [
            (cell[line] if line < len(cell) else "").ljust(width)
            for cell, width in zip(wrapped, columns)
        ]
        print(GAP.join(parts).rstrip())


def print_table(claims):
    rows = [HEADS] + [
        (c.id, c.paper, measured_text(c.measured), c.acceptance, c.verdict) for c in claims
    ]
    columns = widths(rows)
    print_row(rows[0], columns)
    print(GAP.join("-" * width for width in columns))
    for row in rows[1:]:
        print_row(row, columns)


def summary(claims):
    counts = {v: sum(claim.verdict == v for claim in claims) for v in VERDICTS}
    return ", ".join(f"{count} {name}" for name, count in counts.items() if count)


def main(paths):
    for path in map(Path, paths):
        try:
            claims = read_claims(path)
        except (OSError, json.JSONDecodeError, TypeError, ValueError) as error:
            sys.exit(f"print_claims.py: {path} holds no table of claims ({error}).")
        folder = path.resolve().parent
        print(f"\n{folder.name}: {summary(claims) or 'no claims of its own'}")
        print()
        if claims:
            print_table(claims)
        if (folder / SUMMARY).exists():
            print((folder / SUMMARY).read_text(encoding="utf-8"))
        print(f"Pictures and data: {folder}/")


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` is no error
    main(sys.argv[1:])
