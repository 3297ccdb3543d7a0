"""Figure 2, its data and its claims. Without the choice of most_like.py, the picture lacks that
event."""

import numpy as np
import rupture

from claims import paper
from claims.own_result import OwnResult, write_own
from data.records import report, values
from data.tables import write_fronts, write_table
from events.event_claims import case_of_event, claims_of_fronts
from events.units import in_words, of_ensemble, of_loads
from pictures.panels import draw_front_speeds, draw_pinned, draw_pinned_scale, name_line, window_of
from pictures.plotting import BLUE, DOUBLE, GREEN, OF_PAPER, VERMILION, figure, letter, save

MOST_LIKE = "most-like"
EVENTS = {  # label, colour, marker
    "fast-slow-fast": ("event I", BLUE, "o"),
    "fast-only": ("event III", VERMILION, "^"),
    MOST_LIKE: ("most like the paper's", GREEN, "s"),
}
PAPER_SPEEDS = {paper.FAST: "$c_s/3$", paper.SLOW: "$c_s/100$"}  # [c_s]


def first_rupture(front):
    return np.nanmin(values(front["t_rupture"]))


def draw_slow_of_paper(axes, front):
    """The paper's slow stretch, 0.4 L to 0.6 L in 1 ms, from when this front is at 0.4 L."""
    x_over_L = np.array(front["x"]) / front["L"]
    t_from = np.interp(paper.TRANSITIONS[0], x_over_L, values(front["t_rupture"]))
    start = (t_from - first_rupture(front)) * 1e3
    end = start + paper.SLOW_FOR * 1e3
    axes.plot(paper.TRANSITIONS, [start, end], color="white", linewidth=2.5)
    axes.plot(paper.TRANSITIONS, [start, end], **OF_PAPER)
    look = {"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "boxstyle": "square,pad=0.1"}
    place = (paper.TRANSITIONS[1], end)
    offset = {"xytext": (0, 3), "textcoords": "offset points"}
    axes.annotate("paper: 1 ms", place, **offset, ha="right", fontsize=6.5, bbox=look)


def draw_map(axes, front, pinned):
    image = draw_pinned(axes, pinned, *window_of(front))
    if front["slow"]:
        draw_slow_of_paper(axes, front)
    return image


def name_upright_line(axes, text, x):
    """At its upper end, outside the panel."""
    place = {"xycoords": axes.get_xaxis_transform(), "textcoords": "offset points"}
    axes.annotate(text, (x, 1), xytext=(0, 2), ha="center", **place)


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, {name: EVENTS[name] for name in fronts})
    c_s = fronts["fast-slow-fast"]["c_s"]
    for part, text in PAPER_SPEEDS.items():
        axes.axhline(part * c_s, **OF_PAPER)
        name_line(axes, text, part * c_s)
    for x in paper.TRANSITIONS:
        axes.axvline(x, **OF_PAPER)
        name_upright_line(axes, f"${x} L$", x)
    axes.plot([], [], label="paper", **OF_PAPER)
    axes.set(ylim=(1, None))
    look = {"frameon": True, "framealpha": 0.9, "edgecolor": "none", "borderpad": 0.2}
    size = {"ncols": len(fronts) - 1, "handlelength": 1.5, "columnspacing": 1}
    axes.legend(loc="lower right", **look, **size)


def panels(count):
    """Figure, maps and panel of the speeds. Of three maps, the third is below the second."""
    if count == 2:
        fig, axes = figure(DOUBLE, 0.36 * DOUBLE, ncols=3)
        return fig, axes[:2], axes[2]
    fig, axes = figure(DOUBLE, 0.72 * DOUBLE, nrows=2, ncols=2)
    return fig, axes.ravel()[[0, 1, 3]], axes[1, 0]


def draw(data, fronts, stem):
    fig, maps, speeds = panels(len(fronts))
    for axes, name, text in zip(maps, fronts, "ABD"):
        image = draw_map(axes, fronts[name], rupture.open(data / f"{name}-record.h5"))
        axes.set_title(EVENTS[name][0])
        letter(axes, text)
    draw_pinned_scale(fig, image, maps[1:] if len(maps) > 2 else maps)
    draw_speeds(speeds, fronts)
    letter(speeds, "C")
    save(fig, stem)


def own_result(choice):
    """How near the chosen event comes to the paper's."""
    first, *others = choice["candidates"]
    return OwnResult(
        id="nearest",
        question="how near does the event most like the paper's come to it?",
        measured={"loads": choice["loads"], "candidates": 1 + len(others), **first},
    )


def write_choice(results, choice):
    rows = choice["candidates"]
    write_table(results / "most-like.csv", rows[0].keys(), [row.values() for row in rows])


def make(data, results):
    loads = of_ensemble(data, "load", "events")
    choice = report(data / "most-like.json") if (data / "most-like.json").exists() else None
    names = [name for name in EVENTS if choice or name != MOST_LIKE]
    fronts = {name: report(data / f"{name}-front.json") for name in names}
    draw(data, fronts, results / "fig2")
    write_fronts(results / "front-speed.csv", fronts)
    if choice:
        write_choice(results, choice)
    write_own(results, [own_result(choice)] if choice else [])
    slow, fast = fronts["fast-slow-fast"], fronts["fast-only"]
    again = [report(data / f"fast-slow-fast-front-{way}.json") for way in ("in-words", "with-ends")]
    units = of_loads(loads, case_of_event), in_words(loads)
    return claims_of_fronts(slow, *again, fast, *units)
