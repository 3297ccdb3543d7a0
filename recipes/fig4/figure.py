"""Figure 4: A-B here, C in strength_figure.py, D by measure/map_panels.py."""

import rupture
import strength_figure

from claims.claim import Number
from measure.conventions import PRIMARY
from measure.front_map import load_map
from measure.map_panels import write_map
from measure.tables import write_table
from rupture.figures import DOUBLE, figure, letter, save, window_of
from rupture.plotting import draw_pinned, draw_pinned_scale

EVENTS = {"second-slow": "event II", "fast-slow-fast": "event I"}  # the paper shows the first
MAPS = ("map", "map_between", "map_boundary")
MAP = dict(
    panel="D",
    slow_below=(20, 10, 30, 40, 60),
)
EDGES = (
    "sigma_bar",
    "with slow slip: slow from tau_bar_0",
    "fast from",
    "without: not arrested from",
)
REGION = 0.25  # from here on phi was changed [L]


def fronts_of(event):
    return event["front"], event["front_wider"]


def draw_event(axes, event):
    """The pinned fraction, unchanged and with the wider phi, with the same time axis."""
    t_zero, window = window_of(*fronts_of(event))
    for axis, record in zip(axes, ("record.h5", "wider-record.h5")):
        image = draw_pinned(axis, rupture.open(event.file(record)), t_zero, window)
    axes[1].set_ylabel("")
    arrow = {"arrowstyle": "->", "shrinkA": 0, "shrinkB": 0}
    axes[1].annotate("", (1, 0.03), (REGION, 0.03), "axes fraction", "axes fraction", arrow)
    axes[1].annotate(
        r"wider $\varphi$", ((1 + REGION) / 2, 0.05), None, "axes fraction", ha="center"
    )
    return image


def draw(events, stem):
    """Event I above, event II, which the paper shows, below."""
    fig, axes = figure(0.7 * DOUBLE, 0.7 * DOUBLE, nrows=len(events), ncols=2, sharey="row")
    for row, (name, event) in zip(axes, reversed(events.items())):
        image = draw_event(row, event)
        for axis, title in zip(row, ("unchanged", r"wider $\varphi$")):
            axis.set_title(f"{name}, {title}")
        draw_pinned_scale(fig, image, row)
    for axis, text in zip(axes[0], "AB"):
        letter(axis, text)
    save(fig, stem)


def numbers_of_edges(points, results):
    """Where fronts become fast, and not arrested, with slow slip and without it."""
    with_slip, without = (
        {p["sigma-bar"]: p["edges"][PRIMARY] for p in points if p["variant"] == name}
        for name in ("reference", "no slow slip")
    )
    rows = ((s, of["slow"], of["fast"], without[s]["slow"]) for s, of in with_slip.items())
    write_table(results / "edges.csv", EDGES, rows)
    return [
        Number(f"tau_bar_0 from which fronts are {kind}, sigma_bar = 0", None, with_slip[0][kind])
        for kind in ("slow", "fast")
    ]


def make(chains, results):
    points = {point["name"]: point for point in chains["wider"]}
    draw({title: points[name] for name, title in EVENTS.items()}, results / "fig4AB")
    strength_figure.make(chains, results, points)
    fronts, grid = load_map(*(chains[name] for name in MAPS))
    write_map(fronts, grid, results, **MAP)
    return numbers_of_edges(chains["edges"], results)
