"""Figure 4 C and its data."""

from rupture.figures import BLACK, EVENT, SINGLE, figure, letter, save

from events import EVENTS
from fig4.commands import curves, prepared, shown_blocks
from measure.tables import write_table

SHOWN = {"event I": EVENT["I"], "event II": EVENT["II"]}
MARKERS = {"slow": ".", "fast": "x", "loading zone": "o", "arrested": "+"}
CURVES = {"uniform": "-", "bell": "--"}


def draw_kind(axes, kind, colour, blocks=(), **look):
    """Draws the blocks of a kind; without blocks, for the legend."""
    x, y = ([getattr(b, q) for b in blocks if b.kind == kind] for q in ("sigma_bar", "mu_bar_eff"))
    face = "none" if kind == "loading zone" else colour
    axes.plot(x, y, MARKERS[kind], color=colour, markerfacecolor=face, markersize=3.2, **look)


def draw(events, points, lines, stem):
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    for shape, style in CURVES.items():
        axes.plot(*lines[shape], color=BLACK, linestyle=style, linewidth=0.8, label=shape)
    coloured = {name: (colour, events[name]) for name, colour in SHOWN.items()}
    coloured["prepared"] = BLACK, points
    for colour, blocks in coloured.values():
        for kind in ("loading zone", "arrested", "fast", "slow"):
            draw_kind(axes, kind, colour, blocks, markeredgewidth=0.7)
    for kind in MARKERS:
        draw_kind(axes, kind, "grey", label=kind)
    for name, (colour, _) in coloured.items():
        axes.plot([], [], "s", color=colour, label=name)
    axes.legend(loc="lower left", handlelength=1.6)
    axes.set(xlabel=r"$\bar\sigma$", ylabel=r"$\bar\mu_s^\mathrm{eff}$")
    axes.set(xlim=(-0.02, 0.6), ylim=(0, 1.05))
    letter(axes, "C")
    save(fig, stem)


def make(results):
    shown = {name: shown_blocks(name) for name in SHOWN}
    draw(shown, prepared(), curves(), results / "fig4C")
    named = [(f"prepared, {point.shape}", point) for point in prepared()]
    named += [(EVENTS[event], block) for event, blocks in shown.items() for block in blocks]
    names = ["kind", "tau_bar_0", "sigma_bar", "mu_bar_eff"]
    rows = ([name, *(getattr(block, of) for of in names)] for name, block in named)
    write_table(results / "strength.csv", ["points", *names], rows)
