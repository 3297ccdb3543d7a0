#!/usr/bin/env python3
"""The results in README.md: sentences and a picture, made from two tables in docs/. The report
updates them all in a clone where everything has been computed. From the tables alone:

    PYTHONPATH=recipes/common:python python3 recipes/common/report/readme.py
"""

import csv
import hashlib
import json
import re
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

from caption import PLACE, filled
from claims import paper
from claims.claim import SHOWN_ONLY, STANDINGS
from data.records import report
from data.tables import read_rows, write_table
from pictures.panels import name_line
from pictures.plotting import DOUBLE, OF_PAPER, figure
from rupture.replacing import replacing, write_whole

README, PICTURE = "README.md", "docs/figure-2.png"
TABLE, FRONTS = "docs/verdicts.csv", "docs/figure-2.csv"
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


def row_of(result):
    """The share is that under the primary convention, the numbers those that sentences name."""
    found = result.measured.items()
    numbers = {key: short(value) for key, value in found if (result.id, key) in PLACES}
    share = next(iter(getattr(result, "shares", [])), SimpleNamespace(holds="", units=""))
    texts = (getattr(result, name, "") for name in ("closeness_of", "verdict"))
    return [result.id, *texts, share.holds, share.units, json.dumps(numbers)]


def front_rows(name, front):
    """When each block ruptures, after the first, and how fast the front is there."""
    first = min(time for time in front["t_rupture"] if time is not None)
    times = [time and short((time - first) * 1e3, 5) for time in front["t_rupture"]]
    speeds = [speed and short(speed / front["c_s"], 4) for speed in front["v_c"]]
    return [[name, "t [ms]", *times], [name, "v_c/c_s", *speeds]]


def write_tables(root, claims, own):
    """Writes the tables: of claims and own results, and of events with a column per block. An own
    result that `all` leaves out keeps its row."""
    names = ["id", "closeness of", "verdict", "holds", "units", "numbers"]
    ours = {row["id"]: row.values() for row in read_rows(root / TABLE) if not row["verdict"]}
    ours |= {result.id: row_of(result) for result in own}
    named = [row for name, row in ours.items() if name in dict(PLACES)]
    write_table(root / TABLE, names, [*map(row_of, claims), *named])
    fronts = {name: report(root / f"results/data/{name}-front.json") for name in EVENTS}
    x = {short(x / front["L"], 4): None for front in fronts.values() for x in front["x"]}
    rows = [row for name, front in fronts.items() for row in front_rows(name, front)]
    write_table(root / FRONTS, ["event", "x/L", *x], rows)


def sentences(rows):
    """From the table of verdicts; `all` counts those of leading rows, `closer` the others."""
    results = {row["id"]: row | json.loads(row["numbers"]) for row in rows}
    for name, is_closer in (("all", False), ("closer", True)):
        of = (row for row in rows if row["verdict"] and bool(row["closeness of"]) == is_closer)
        counts = Counter(row["verdict"] for row in of)
        results[name] = dict.fromkeys(STANDINGS, 0) | counts | {"claims": counts.total()}
    return filled(SENTENCES, [SimpleNamespace(id=i, measured=m) for i, m in results.items()])


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
    write_whole(root / README, BLOCK.sub(lambda _: sentences(read_rows(root / TABLE)), text))
    draw(root / PICTURE, (root / FRONTS).read_text(encoding="utf-8"))


def update_readme(root, claims, own):
    """Does nothing in other folders, or if something has not run. Follows no link."""
    paths = [root / name for name in (README, PICTURE, TABLE, FRONTS)]
    is_clone = all(path.is_file() and path.resolve() == path for path in paths)
    named = [claim for claim in claims if claim.id in dict(PLACES)]
    if is_clone and not any(claim.reason.startswith(SHOWN_ONLY) for claim in named):
        write_tables(root, claims, own)
        write_readme(root)


if __name__ == "__main__":
    write_readme(Path(__file__).resolve().parents[3])
