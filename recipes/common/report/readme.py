"""The results in README.md: sentences and a picture, which is drawn from a table in docs/. The
report updates them in a clone where everything has been computed."""

import csv
import hashlib
import re
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

from caption import PLACE, filled
from claims import paper
from claims.claim import SHOWN_ONLY, VERDICTS
from data.records import report
from data.tables import write_table
from pictures.panels import name_line
from pictures.plotting import DOUBLE, OF_PAPER, figure
from rupture.replacing import replacing, write_whole

README, PICTURE = "README.md", "docs/figure-2.png"
FRONTS = "docs/figure-2.csv"
BLOCK = re.compile(r"<!-- results (\w*) -->\n(.*?)<!-- /results -->", re.DOTALL)
SENTENCES = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
EVENTS = {  # label, colour, marker
    "fast-slow-fast": ("event I", "#009e73", "o"),
    "fast-only": ("event III", "#56b4e9", "^"),
    "most-like": ("most like the paper's", "#000000", "s"),
}


def short(value, digits):
    return float(f"{value:.{digits}g}")


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


# --- sentences -----------------------------------------------------------------------------


def sentences(claims, own):
    """Of leading rows: `all` counts them, shares are those under the primary convention."""
    leading = [claim for claim in claims if not claim.closeness_of]
    counts = Counter(claim.verdict for claim in leading)
    further = {claim.id: vars(claim.shares[0]) for claim in leading if claim.shares}
    further["all"] = dict.fromkeys(VERDICTS, 0) | counts | {"claims": len(leading)}
    of_further = (SimpleNamespace(id=name, measured=found) for name, found in further.items())
    return filled(SENTENCES, [*leading, *own, *of_further])


def block(text):
    """With a digest, by which a test sees that nobody has edited it."""
    return f"<!-- results {digest(text)[:12]} -->\n{text}<!-- /results -->"


# --- picture -------------------------------------------------------------------------------


def front_rows(name, front):
    """When each block ruptures, after the first, and how fast the front is there."""
    first = min(time for time in front["t_rupture"] if time is not None)
    times = [time and short((time - first) * 1e3, 5) for time in front["t_rupture"]]
    speeds = [speed and short(speed / front["c_s"], 4) for speed in front["v_c"]]
    return [[name, "t [ms]", *times], [name, "v_c/c_s", *speeds]]


def write_fronts(root):
    """A column per block."""
    fronts = {name: report(root / f"results/data/{name}-front.json") for name in EVENTS}
    x = {short(x / front["L"], 4): None for front in fronts.values() for x in front["x"]}
    rows = [row for name, front in fronts.items() for row in front_rows(name, front)]
    write_table(root / FRONTS, ["event", "x/L", *x], rows)


def draw(path, table):
    """The PNG names the table from which it is drawn. It is drawn again if that changes, not with
    each version of Matplotlib; to have it drawn again, empty it."""
    source = digest(table)
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


# --- both ----------------------------------------------------------------------------------


def update_readme(root, claims, own):
    """Does nothing in other folders, or if something has not run. Follows no link."""
    paths = [root / name for name in (README, PICTURE, FRONTS)]
    is_clone = all(path.is_file() and path.resolve() == path for path in paths)
    named = [claim for claim in claims if claim.id in dict(PLACE.findall(SENTENCES))]
    if is_clone and not any(claim.reason.startswith(SHOWN_ONLY) for claim in named):
        written = block(sentences(claims, own))
        text = (root / README).read_text(encoding="utf-8")
        write_whole(root / README, BLOCK.sub(lambda _: written, text))
        write_fronts(root)
        draw(root / PICTURE, (root / FRONTS).read_text(encoding="utf-8"))
