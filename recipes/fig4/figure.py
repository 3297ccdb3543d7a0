"""Figure 4: A-B and their claim here, C in strength.py, D by common/maps, its edges in edge.py."""

import edge
import rupture
import strength

from data.records import report
from events.event_claims import judged_event
from events.units import of_ensemble, of_events
from maps.map_claims import make_map
from pictures.panels import draw_pinned, draw_pinned_scale, window_of
from pictures.plotting import DOUBLE, figure, letter, save

EVENTS = {"second-slow": "event II", "fast-slow-fast": "event I"}  # the paper shows the first
MAP = dict(
    panel="D",
    tables=["map-between", "map-boundary"],
    slow_below=(20, 10, 30, 40, 60),
    claim="4D",
)
REGION = 0.25  # from here on phi was changed [L]


def fronts_of(data, event):
    return [report(data / f"{run}-front.json") for run in (event, f"{event}/wider")]


def draw_event(axes, data, event):
    """The pinned fraction, unchanged and with the wider phi, with the same time axis."""
    t_zero, window = window_of(*fronts_of(data, event))
    for axis, run in zip(axes, (event, f"{event}/wider")):
        image = draw_pinned(axis, rupture.open(data / f"{run}-record.h5"), t_zero, window)
    axes[1].set_ylabel("")
    arrow = {"arrowstyle": "->", "shrinkA": 0, "shrinkB": 0}
    axes[1].annotate("", (1, 0.03), (REGION, 0.03), "axes fraction", "axes fraction", arrow)
    axes[1].annotate(
        r"wider $\varphi$", ((1 + REGION) / 2, 0.05), None, "axes fraction", ha="center"
    )
    return image


def draw(data, stem):
    """Event I above, event II, which the paper shows, below."""
    fig, axes = figure(0.7 * DOUBLE, 0.7 * DOUBLE, nrows=len(EVENTS), ncols=2, sharey="row")
    for row, (event, name) in zip(axes, reversed(EVENTS.items())):
        image = draw_event(row, data, event)
        for axis, title in zip(row, ("unchanged", r"wider $\varphi$")):
            axis.set_title(f"{name}, {title}")
        draw_pinned_scale(fig, image, row)
    for axis, text in zip(axes[0], "AB"):
        letter(axis, text)
    save(fig, stem)


def make(data, results):
    draw(data, results / "fig4AB")
    phi = {e: [report(data / f"{e}{of}-phi.json") for of in ("", "/wider-start")] for e in EVENTS}
    events = {name: (*fronts_of(data, event), *phi[event]) for event, name in EVENTS.items()}
    units = of_events(of_ensemble(data, "load", "continued"), "4AB")
    return [
        judged_event("4AB", events, units),
        *strength.make(data, results),
        *make_map(data, results, **MAP),
        *edge.make(data, results),
    ]
