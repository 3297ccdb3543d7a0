#!/usr/bin/env python3
"""The results in README.md: sentences and a picture, made from two tables in docs/. The report
updates them all in a clone where everything has been computed. From the tables alone:

    PYTHONPATH=recipes:python python3 -m report.readme
"""

import csv
import hashlib
import json
import re
from collections import Counter
from dataclasses import fields
from pathlib import Path
from types import SimpleNamespace

from report.caption import PLACE, filled
from claims import paper
from claims.claim import VERDICTS, Number, number
from measure.records import report
from measure.tables import read_rows, write_table
from report.panels import name_line
from report.plotting import DOUBLE, OF_PAPER, figure
from rupture.replacing import replacing, write_whole

README, PICTURE = "README.md", "docs/figure-2.png"
TABLE, NUMBERS, FRONTS = "docs/verdicts.csv", "docs/numbers.csv", "docs/figure-2.csv"
FIRST, FIRST_ROUND = "docs/first-criteria.csv", "2026-11-21"  # criteria, and when those were fixed
AFTER_RESULTS = re.compile(r"\bafter\b")  # in when a criterion was fixed
BLOCK = re.compile(r"(?<=<!-- results -->\n).*?(?=<!-- /results -->)", re.DOTALL)
SENTENCES = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
PLACES = set(PLACE.findall(SENTENCES))
EVENTS = {  # label, colour, marker
    "fast-slow-fast": ("event I", "#009e73", "o"),
    "fast-only": ("event III", "#56b4e9", "^"),
    "most-like": ("most like the paper's", "#000000", "s"),
}


def short(value, digits=3):
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value


def row_of(result, version):
    """The share is that under the primary convention, the numbers those that sentences name."""
    found = result.measured.items()
    numbers = {key: short(value) for key, value in found if (result.id, key) in PLACES}
    share = next(iter(getattr(result, "shares", [])), SimpleNamespace(holds="", units=""))
    texts = (getattr(result, name, "") for name in ("kind", "fixed", "verdict"))
    return [result.id, *texts, share.holds, share.units, version, json.dumps(numbers)]


def fronts_of_figure_2(root):
    """{event: report of `analyze front`}, from the points that the figure has read."""
    chains = report(root / "results/data/fig2/figure.json")
    points = [lineage[0] for name in ("event", "most_like") for lineage in chains[name]]
    names = [point["values"].get("name", "most-like") for point in points]
    found = {name: point["path"] for name, point in zip(names, points)}
    return {name: report(root / found[name])["reports"]["front"] for name in EVENTS}


def front_rows(name, front):
    """When each block ruptures, after the first, and how fast the front is there."""
    first = min(time for time in front["t_rupture"] if time is not None)
    times = [time and short((time - first) * 1e3, 5) for time in front["t_rupture"]]
    speeds = [speed and short(speed / front["c_s"], 4) for speed in front["v_c"]]
    return [[name, "t [ms]", *times], [name, "v_c/c_s", *speeds]]


def write_tables(root, claims, own, numbers, version):
    """Writes the tables: of claims and own results, of the paper's numbers, and of events with a
    column per block. An own result that `all` leaves out keeps its row."""
    names = ["id", "kind", "fixed", "verdict", "holds", "units", "version", "numbers"]
    ours = {row["id"]: row.values() for row in read_rows(root / TABLE) if not row["verdict"]}
    ours |= {result.id: row_of(result, version) for result in own}
    named = [row for name, row in ours.items() if name in dict(PLACES)]
    write_table(root / TABLE, names, [*(row_of(claim, version) for claim in claims), *named])
    write_numbers(root / NUMBERS, numbers)
    fronts = fronts_of_figure_2(root)
    x = {short(x / front["L"], 4): None for front in fronts.values() for x in front["x"]}
    rows = [row for name, front in fronts.items() for row in front_rows(name, front)]
    write_table(root / FRONTS, ["event", "x/L", *x], rows)


def write_numbers(path, numbers):
    """The paper's numbers beside ours, in six digits."""
    columns = [*(field.name for field in fields(Number)), "ratio"]
    rows = ([short(getattr(one, name), 6) for name in columns] for one in numbers)
    write_table(path, columns, rows)


def table_of(rows):
    """As Markdown, those of which the paper has a number."""

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
    """Of verdicts, and of criteria worded after results."""
    verdicts = Counter(row["verdict"] for row in rows)
    of_reproduced = [row["fixed"] for row in rows if row["verdict"] == "reproduced"]
    late = sum(bool(AFTER_RESULTS.search(fixed)) for fixed in of_reproduced)
    counts = dict.fromkeys(VERDICTS, 0) | verdicts
    return counts | {"claims": verdicts.total(), "reproduced after results": late}


def sentences(root):
    """From the tables in docs/."""
    rows, numbers = (read_rows(root / name) for name in (TABLE, NUMBERS))
    results = {row["id"]: row | json.loads(row["numbers"]) for row in rows}
    for name, kind in (("findings", "finding"), ("checks", "check")):
        results[name] = counts_of([row for row in rows if row["kind"] == kind])
    results["numbers"] = {"events": numbers[0]["of"].split()[2]}
    first = (row for row in read_rows(root / FIRST) if row["fixed"].startswith(FIRST_ROUND))
    results["first"] = counts_of([*first])
    text = filled(SENTENCES, [SimpleNamespace(id=i, measured=m) for i, m in results.items()])
    return text.replace("{table}", table_of(numbers))


def draw(path, table):
    """The PNG names the table from which it is drawn. It is drawn again if that changes, not with
    each version of Matplotlib; to have it drawn again, empty it."""
    source = hashlib.sha256(table.encode()).hexdigest()
    if source.encode() in path.read_bytes():
        return
    fig, panels = figure(DOUBLE, 0.4 * DOUBLE, ncols=2)
    (_, _, *x), *rows = csv.reader(table.splitlines())
    for (name, _, *cells), axes in zip(rows, len(EVENTS) * [*panels]):
        label, colour, marker = EVENTS[name]
        y = [float(cell or "nan") for cell in cells]
        forwards = [value if value >= 0 else float("nan") for value in y]
        axes.plot([*map(float, x)], forwards, color=colour, marker=marker, label=label)
    for axes in panels:
        for place in paper.TRANSITIONS:
            axes.axvline(place, **OF_PAPER)
        axes.set(xlabel="position $x/L$", xlim=(0, 1))
    for speed, text in ((paper.FAST, "1/3"), (paper.SLOW, "1/100")):
        panels[1].axhline(speed, **OF_PAPER)
        name_line(panels[1], text, speed)
    panels[0].plot([], [], **OF_PAPER, label="paper")
    panels[0].set(ylabel="time after the first rupture [ms]", ylim=(0, None))
    panels[1].set(ylabel="front speed $v_c/c_s$", yscale="log")
    panels[0].legend(loc="upper left", frameon=True, framealpha=1, edgecolor="none")
    with replacing(path) as temporary:
        fig.savefig(temporary, format="png", dpi=160, metadata={"Software": None, "Source": source})


def write_readme(root):
    text = (root / README).read_text(encoding="utf-8")
    write_whole(root / README, BLOCK.sub(lambda _: sentences(root), text))
    draw(root / PICTURE, (root / FRONTS).read_text(encoding="utf-8"))


def update_readme(root, claims, own, numbers, version):
    """Does nothing in other folders, or if something has not run. Follows no link."""
    paths = [root / name for name in (README, PICTURE, TABLE, NUMBERS, FRONTS)]
    is_clone = all(path.is_file() and path.resolve() == path for path in paths)
    if is_clone and all(claim.verdict for claim in claims):
        write_tables(root, claims, own, numbers, version)
        write_readme(root)


if __name__ == "__main__":
    write_readme(Path(__file__).resolve().parents[2])
