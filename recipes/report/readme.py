#!/usr/bin/env python3
"""The results in README.md: sentences from two tables in docs/, and the picture of Figure 2. The
report updates them all in a clone where everything has been computed. From the tables alone:

    PYTHONPATH=recipes:python python3 -m report.readme
"""

import json
import re
import shutil
from collections import Counter
from dataclasses import fields
from pathlib import Path
from types import SimpleNamespace

from report.caption import PLACE
from claims.claim import DIFFERS, REPRODUCED, VERDICTS, Number
from claims.conditions import met
from measure.tables import read_rows, write_table
from rupture.errors import Failure
from rupture.replacing import replacing, write_whole

README, PICTURE = "README.md", "docs/figure-2.png"
TABLE, NUMBERS = "docs/verdicts.csv", "docs/numbers.csv"
EXPECTED = "docs/expected.csv"  # before any run on the frozen seeds
AFTER_RESULTS = re.compile(r"\b(after|knowing)\b")  # in when a criterion was fixed
BLOCK = re.compile(r"(?<=<!-- results -->\n).*?(?=<!-- /results -->)", re.DOTALL)
SENTENCES = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
PLACES = set(PLACE.findall(SENTENCES))


def short(value, digits=3):
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value


def expectations(root):
    """{claim: a share as "0.6 to 0.8", or a verdict}, as they were written down."""
    return {row["id"]: row["expected"] for row in read_rows(root / EXPECTED)}


def is_as_expected(row):
    low, to, high = row["expected"].partition(" to ")
    if not to:
        return row["verdict"] == row["expected"]
    return float(low) <= int(row["holds"]) / int(row["samples"]) <= float(high)


def row_of(result, version, expected=""):
    """The share is that in the primary way, the numbers those that sentences name."""
    asked = getattr(result, "expected", {})
    found = result.measured | {
        "expectations": len(asked),
        "met": sum(met(condition, result.measured[name]) for name, condition in asked.items()),
    }
    shares = getattr(result, "shares", [])
    found |= {share.way: f"{share.holds} of {share.samples}" for share in shares}
    numbers = {key: short(value, 4) for key, value in found.items() if (result.id, key) in PLACES}
    primary = next(iter(shares), SimpleNamespace(holds="", samples=""))
    texts = (getattr(result, name, "") for name in ("kind", "fixed", "verdict"))
    share = (primary.holds, primary.samples)
    return [result.id, *texts, *share, version, expected, json.dumps(numbers)]


def write_tables(root, claims, own, numbers, version):
    """Writes the tables: of claims and own results, and of the paper's numbers. An own result that
    `all` leaves out keeps its row."""
    names = ["id", "kind", "fixed", "verdict", "holds", "samples", "version", "expected", "numbers"]
    expected = expectations(root)
    ours = {row["id"]: row.values() for row in read_rows(root / TABLE) if not row["kind"]}
    ours |= {result.id: row_of(result, version) for result in own}
    named = [row for name, row in ours.items() if name in dict(PLACES)]
    rows = (row_of(claim, version, expected.get(claim.id, "")) for claim in claims)
    write_table(root / TABLE, names, [*rows, *named])
    write_numbers(root / NUMBERS, numbers)


def write_numbers(path, numbers):
    """The paper's numbers beside ours, in six digits."""
    columns = [*(field.name for field in fields(Number)), "ratio"]
    rows = ([short(getattr(one, name), 6) for name in columns] for one in numbers)
    write_table(path, columns, rows)


def as_shown(name, value):
    """With the digits that the lattice allows: a block is 0.018 L, a stencil 0.07 L."""
    if not isinstance(value, float):
        return value
    if name.endswith("/c_s"):
        return f"c_s/{1 / value:.2g}"
    return f"{value:.2f}" if name.endswith("[L]") else short(value, 2 if "[" in name else 3)


def counts_of(rows):
    """Counts verdicts, criteria worded or changed after results, and results that are as expected;
    names what differs."""
    verdicts = Counter(row["verdict"] for row in rows)
    of_reproduced = [row["fixed"] for row in rows if row["verdict"] == REPRODUCED]
    late = sum(bool(AFTER_RESULTS.search(fixed)) for fixed in of_reproduced)
    counts: dict = dict.fromkeys(VERDICTS, 0) | verdicts
    differ = ", ".join(row["id"] for row in rows if row["verdict"] == DIFFERS)
    counts |= {"that differ": differ or "none", "reproduced after results": late}
    foreseen = [is_as_expected(row) for row in rows if row["expected"]]
    counts |= {"expected": len(foreseen), "as expected": sum(foreseen)}
    return counts | {"claims": verdicts.total()}


def sentences(root):
    """From the table in docs/. A place that nothing fills is an error."""
    rows = read_rows(root / TABLE)
    numbers = {row["id"]: json.loads(row["numbers"]) for row in rows}
    found = {
        row["id"]: row | {name: as_shown(name, of) for name, of in numbers[row["id"]].items()}
        for row in rows
    }
    for name, kind in (("findings", "finding"), ("checks", "check")):
        found[name] = counts_of([row for row in rows if row["kind"] == kind and row["verdict"]])
    if missing := [f"{i}: {name}" for i, name in PLACES if name not in found.get(i, {})]:
        raise Failure(f"README.md has places that nothing fills: {'; '.join(sorted(missing))}")
    return PLACE.sub(lambda place: str(found[place[1]][place[2]]), SENTENCES)


def write_readme(root):
    text = (root / README).read_text(encoding="utf-8")
    write_whole(root / README, BLOCK.sub(lambda _: sentences(root), text))


def update_readme(root, claims, own, numbers, version):
    """Does nothing in other folders, or if something has not run. Follows no link."""
    paths = [root / name for name in (README, PICTURE, TABLE, NUMBERS)]
    is_clone = all(path.is_file() and path.resolve() == path for path in paths)
    if is_clone and all(claim.verdict for claim in claims):
        before = (root / NUMBERS).read_bytes()
        write_tables(root, claims, own, numbers, version)
        write_readme(root)
        if (root / NUMBERS).read_bytes() != before:  # not with each version of Matplotlib
            with replacing(root / PICTURE) as temporary:
                shutil.copyfile(root / "results/fig2/fig2.png", temporary)


if __name__ == "__main__":
    write_readme(Path(__file__).resolve().parents[2])
