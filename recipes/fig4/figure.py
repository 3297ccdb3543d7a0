"""Figure 4: A-B here, C in strength_figure.py, D by measure/map_panels.py."""

import rupture
from rupture.figures import DOUBLE, figure, letter, save, window_of
from rupture.plotting import draw_pinned, draw_pinned_scale

from claims.claim import Number
from fig4 import strength_figure
from fig4.commands import REGION, SHOWN, map_of_types, edges_with_and_without, wider
from measure.ways import PRIMARY
from measure.map_panels import write_map
from measure.tables import write_table

SLOW_BELOW = (20, 10, 30, 40, 60)  # c_s over these
EDGES = (
    "sigma_bar",
    "with slow slip: slow from tau_bar_0",
    "fast from",
    "without: not arrested from",
)


def fronts_of(event):
    return event.front, event.wider[PRIMARY]


def draw_event(axes, event):
    """The pinned fraction, unchanged and with the wider phi, with the same time axis."""
    t_zero, window = window_of(*fronts_of(event))
    for axis, record in zip(axes, (event.record, event.wider_record)):
        image = draw_pinned(axis, rupture.open(record), t_zero, window)
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


def numbers_of_edges(results):
    """The prestress from which fronts are fast, and not arrested, with slow slip and without it."""
    pairs = {s: [of[PRIMARY] for of in both] for s, both in edges_with_and_without().items()}
    rows = ((s, on["slow"], on["fast"], off["slow"]) for s, (on, off) in pairs.items())
    write_table(results / "edges.csv", EDGES, rows)
    return [
        Number(f"tau_bar_0 from which fronts are {kind}, sigma_bar = 0", None, pairs[0][0][kind])
        for kind in ("slow", "fast")
    ]


def make(results):
    draw({name: wider(name) for name in SHOWN}, results / "fig4AB")
    strength_figure.make(results)
    of = map_of_types()
    write_map(of.fronts, of.on_grid(), results, panel="D", slow_below=SLOW_BELOW)
    return numbers_of_edges(results)
