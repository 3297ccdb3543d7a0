"""Figure 2 and its data. Without the choice of most_like.py, the picture lacks that
event."""

import shutil
from itertools import chain

import rupture
from rupture.errors import Failure
from rupture.figures import BLACK, DOUBLE, EVENT, OF_PAPER, draw_ahead, draw_front_speeds
from rupture.figures import lettered, save, window_of
from rupture.plotting import draw_pinned, draw_pinned_scale, name_line
from rupture.replacing import replacing

import paper
from event_numbers import at_transitions, numbers_of_events
from events import runs, shown_event
from fig2.commands import OF_STRETCH, by_order, film, median_of, most_like_if_known
from fig2.most_like import COLUMNS
from measure.ways import PRIMARY
from measure.tables import write_columns, write_fronts, write_table

MOST_LIKE = "most-like"
EVENTS = {  # label, colour, marker
    "fast-slow-fast": ("event I", EVENT["I"], "o"),
    "second-slow": ("event II", EVENT["II"], "v"),
    "fast-only": ("event III", EVENT["III"], "^"),
    MOST_LIKE: ("most like the paper's", BLACK, "s"),
}
PAPER_SPEEDS = {paper.FAST: "$c_s/3$", paper.SLOW: "$c_s/100$"}  # [c_s]


def draw_slow_of_paper(axes, front):
    """The paper's slow stretch, 0.4 L to 0.6 L in 1 ms, from when this front is at 0.4 L."""
    start, _ = at_transitions(front)
    end = start + paper.SLOW_FOR * 1e3
    axes.plot(paper.TRANSITIONS, [start, end], color="white", linewidth=2.5)
    axes.plot(paper.TRANSITIONS, [start, end], **OF_PAPER)
    look = {"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "boxstyle": "square,pad=0.1"}
    place = (paper.TRANSITIONS[1], end)
    offset = {"xytext": (0, 3), "textcoords": "offset points"}
    axes.annotate("paper: 1 ms", place, **offset, ha="right", fontsize=6.5, bbox=look)


def draw_map(axes, front, pinned):
    t_zero, window = window_of(front)
    image = draw_pinned(axes, pinned, t_zero, window)
    axes.set(ylabel="time since it began [ms]")
    draw_ahead(axes, front, t_zero, color="white")
    if front["slow"]:
        draw_slow_of_paper(axes, front)
    return image


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, {name: EVENTS[name] for name in fronts})
    c_s = fronts["fast-slow-fast"]["c_s"]
    for part, text in PAPER_SPEEDS.items():
        axes.axhline(part * c_s, zorder=1, **OF_PAPER)
        name_line(axes, f"{text}\npaper", part * c_s)
    above = {"xycoords": axes.get_xaxis_transform(), "textcoords": "offset points", "ha": "center"}
    for x in paper.TRANSITIONS:
        axes.axvline(x, ymin=0.28, zorder=1, **OF_PAPER)  # above the legend
        axes.annotate(f"${x}\\,L$", (x, 1), xytext=(0, 2), **above)
    axes.plot([], [], label="paper", **OF_PAPER)
    axes.set(ylim=(0.3, None))
    look = {"frameon": True, "framealpha": 1, "edgecolor": "none", "borderpad": 0.2}
    axes.legend(loc="lower right", ncols=3, handlelength=1.5, columnspacing=1, **look)


def draw(events, fronts, stem):
    """The speeds are below the first maps, beside that of the event most like the paper's."""
    fig, panels = lettered("ABC;DDE" if MOST_LIKE in fronts else "ABC;DDD", DOUBLE, 0.68 * DOUBLE)
    for text, name in zip("ABCE", fronts):
        image = draw_map(panels[text], fronts[name], rupture.open(events[name].record))
        panels[text].set_title(EVENTS[name][0])
    draw_pinned_scale(fig, image, list(panels.values()), shrink=0.6)
    draw_speeds(panels["D"], fronts)
    save(fig, stem)


def write_by_order(path, shown, runs):
    """The first fast-slow-fast event of each run, all later ones, and event I."""
    of_paper = [*paper.TRANSITIONS, paper.SLOW, paper.FAST, paper.SLOW_FOR * 1e3]
    orders = by_order(runs)
    rows = [
        [name, at, *(x for of in orders.values() for x in median_of(name, of)), measure(shown)]
        for (name, measure), at in zip(OF_STRETCH.items(), of_paper)
    ]
    names = [f"{order}: {text}" for order in orders for text in ("median", "low", "high")]
    write_table(path, ["below c_s/10", "paper", *names, "event I"], rows)


def make(results):
    events = {name: shown_event(name) for name in EVENTS if name != MOST_LIKE}
    if found := most_like_if_known():
        events[MOST_LIKE] = found
    fronts = {name: of.front for name, of in events.items()}
    draw(events, fronts, results / "fig2")
    write_fronts(results / "front-speed-II.csv", {"second-slow": fronts.pop("second-slow")})
    write_fronts(results / "front-speed.csv", fronts)
    write_columns(results / "most-like.csv", COLUMNS, found.candidates if found else [])
    slow, fast = fronts["fast-slow-fast"], fronts["fast-only"]
    of_runs = [of for _, of in runs() if not isinstance(of, Failure)]
    write_by_order(results / "by-order.csv", slow, of_runs)
    with replacing(results / "movie.gif") as temporary:
        shutil.copyfile(film(), temporary)
    events_of_runs = [*chain(*(of[PRIMARY] for of in of_runs))]
    return numbers_of_events(slow, fast, fronts.get(MOST_LIKE), events_of_runs)
