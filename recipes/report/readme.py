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

from report.caption import PLACE, filled
from claims.claim import VERDICTS, Number, number
from measure.tables import read_rows, write_table
from rupture.replacing import replacing, write_whole

README, PICTURE = "README.md", "docs/figure-2.png"
TABLE, NUMBERS = "docs/verdicts.csv", "docs/numbers.csv"
FIRST, FIRST_ROUND = "docs/first-criteria.csv", "2026-11-21"  # criteria, and when those were fixed
AFTER_RESULTS = re.compile(r"\b(after|knowing)\b")  # in when a criterion was fixed
BLOCK = re.compile(r"(?<=<!-- results -->\n).*?(?=<!-- /results -->)", re.DOTALL)
SENTENCES = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
PLACES = set(PLACE.findall(SENTENCES))


def short(value, digits=3):
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value


def row_of(result, version):
    """The share is that under the primary convention, the numbers those that sentences name."""
    found = result.measured.items()
    numbers = {key: short(value) for key, value in found if (result.id, key) in PLACES}
    share = next(iter(getattr(result, "shares", [])), SimpleNamespace(holds="", units=""))
    texts = (getattr(result, name, "") for name in ("kind", "fixed", "verdict"))
    return [result.id, *texts, share.holds, share.units, version, json.dumps(numbers)]


def write_tables(root, claims, own, numbers, version):
    """Writes the tables: of claims and own results, and of the paper's numbers. An own result that
    `all` leaves out keeps its row."""
    names = ["id", "kind", "fixed", "verdict", "holds", "units", "version", "numbers"]
    ours = {row["id"]: row.values() for row in read_rows(root / TABLE) if not row["kind"]}
    ours |= {result.id: row_of(result, version) for result in own}
    named = [row for name, row in ours.items() if name in dict(PLACES)]
    write_table(root / TABLE, names, [*(row_of(claim, version) for claim in claims), *named])
    write_numbers(root / NUMBERS, numbers)


def write_numbers(path, numbers):
    """The paper's numbers beside ours, in six digits."""
    columns = [*(field.name for field in fields(Number)), "ratio"]
    rows = ([short(getattr(one, name), 6) for name in columns] for one in numbers)
    write_table(path, columns, rows)


def table_of(rows):
    """The table in Markdown, with the rows of which the paper has a number."""

    def cell(row, *names):
        found = [number(float(row[name])) if row[name] else "" for name in names]
        return found[0] + (f" ({found[1]} to {found[2]})" if found[1:] and found[1] else "")

    lines = ["| | paper | our event most like it | our median (5 to 95 %) |", "|---|---|---|---|"]
    for row in rows:
        if row["paper"]:
            ours = cell(row, "median", "low", "high") or cell(row, "shown")
            cells = cell(row, "paper"), cell(row, "most_like"), ours
            lines.append(f"| {row['quantity']} | {' | '.join(cells)} |")
    return re.sub(r"<(\w+)>", r"⟨\1⟩", "\n".join(lines)) + "\n"  # no tag of HTML


def counts_of(rows):
    """Counts verdicts, and criteria worded or changed after results."""
    verdicts = Counter(row["verdict"] for row in rows)
    of_reproduced = [row["fixed"] for row in rows if row["verdict"] == "reproduced"]
    late = sum(bool(AFTER_RESULTS.search(fixed)) for fixed in of_reproduced)
    counts = dict.fromkeys(VERDICTS, 0) | verdicts
    return counts | {"claims": verdicts.total(), "reproduced after results": late}


def sentences(root):
    """The results in words, from the tables in docs/."""
    rows, numbers = (read_rows(root / name) for name in (TABLE, NUMBERS))
    results = {row["id"]: row | json.loads(row["numbers"]) for row in rows}
    for name, kind in (("findings", "finding"), ("checks", "check")):
        results[name] = counts_of([row for row in rows if row["kind"] == kind and row["verdict"]])
    first = (row for row in read_rows(root / FIRST) if row["fixed"].startswith(FIRST_ROUND))
    results["first"] = counts_of([*first])
    text = filled(SENTENCES, [SimpleNamespace(id=i, measured=m) for i, m in results.items()])
    return text.replace("{table}", table_of(numbers))


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
