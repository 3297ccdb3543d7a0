"""Figure 4: A-B and their claim here, C in strength.py, D by measure, its edges in edge.py."""

import edge
import rupture
import strength

from measure.event_claims import judged_event
from measure.cases import continued_of, of_events
from measure.front_map import load_map
from measure.map_claims import make_map
from report.panels import draw_pinned, draw_pinned_scale, window_of
from report.plotting import DOUBLE, figure, letter, save

EVENTS = {"second-slow": "event II", "fast-slow-fast": "event I"}  # the paper shows the first
MAPS = ("map", "map_between", "map_boundary")
MAP = dict(
    panel="D",
    slow_below=(20, 10, 30, 40, 60),
    claim="4D",
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


def make(chains, results):
    points = {point["name"]: point for point in chains["wider"]}
    events = {title: points[name] for name, title in EVENTS.items()}
    draw(events, results / "fig4AB")
    measured = {
        title: (*fronts_of(event), event["phi"], event["phi_wider"])
        for title, event in events.items()
    }
    fronts, grid = load_map(*(chains[name] for name in MAPS))
    continued = continued_of(chains["ensemble/branches"])
    return [
        judged_event("4AB", measured, of_events(continued, "4AB")),
        *strength.make(chains, results, points, fronts, grid, continued),
        *make_map(fronts, grid, results, **MAP),
        *edge.make(chains["edges"], results),
    ]
