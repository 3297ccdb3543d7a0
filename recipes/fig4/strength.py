"""Figure 4 C, its data and claim 4C."""

from collections import namedtuple

import numpy as np

from claims.judge import judged
from measure.rank_test import permutation, share_of_lower, signed_rank, van_elteren
from measure.records import values
from measure.tables import write_table
from measure.conventions import PRIMARY
from measure.fronts import LOADING_ZONE, SLOW_BELOW
from measure.front_map import map_of_seed, seeds_of, type_on_map, types_of
from measure.map_claims import ABOUT_UNITS, units_of_seeds
from report.plotting import BLACK, EVENT, SINGLE, figure, letter, save

SHOWN = {"fast-slow-fast": ("I", EVENT["I"]), "second-slow": ("II", EVENT["II"])}
BINS = (0.1, 0.05, 0.2)  # of tau_bar_0: blocks in one bin count as equally loaded; primary first
WAYS = {
    PRIMARY: {"test": "van Elteren", "width": BINS[0]},
    **{f"bins of {width:g}": {"test": "van Elteren", "width": width} for width in BINS[1:]},
    "permutation test": {"test": "permutation", "width": BINS[0]},
}
MARKERS = {"slow": ".", "fast": "x", "loading zone": "o", "arrested": "+"}
CURVES = {"uniform": "-", "bell": "--"}
MIDDLE = 40  # a block between the trigger region and the leading edge
FEWEST_EVENTS = 5  # for a test over events
KINDS = ("slow", "fast")
# Of an event, or of a prepared interface, where all beyond the trigger region are alike; `kind` is
# one of MARKERS, `shape` that of a prepared phi.
Block = namedtuple("Block", "kind sigma_bar tau_bar_0 mu_bar_eff shape", defaults=[""])


# --- data ----------------------------------------------------------------------------------


def kind_of(x, v_c, c_s):
    """None where no speed is known, or where the front ran backwards."""
    if x < LOADING_ZONE:
        return "loading zone"
    if not v_c > 0:
        return None
    return "slow" if v_c < SLOW_BELOW * c_s else "fast"


def blocks_of(front, strength):
    """The blocks of one event: what they could bear before it, how fast the front passed them."""
    kinds = [kind_of(x, v, front["c_s"]) for x, v in zip(front["x"], values(front["v_c"]))]
    quantities = zip(*(values(strength[q]) for q in ("sigma_bar", "tau_bar_0", "mu_bar_eff")))
    return [Block(kind, *of_block) for kind, of_block in zip(kinds, quantities) if kind]


def prepared_points(points):
    """The block in the middle of prepared interfaces, without those that cannot be prepared."""
    return [
        Block(
            type_on_map(point["front"]["type"]),
            point["strength"]["sigma_bar"][MIDDLE],
            point["tau-bar"],
            point["strength"]["mu_bar_eff"][MIDDLE],
            point["shape"],
        )
        for point in points
        if point.status == "done"
    ]


def lines_of(points):
    """{shape: (sigma_bar, mu_bar_eff)}"""
    pairs = [(p["shape"], p["sigma-bar"], p["strength"]["mu_bar_eff"]) for p in points]
    return {shape: [*zip(*(xy for of, *xy in pairs if of == shape))] for shape in CURVES}


# --- tests ---------------------------------------------------------------------------------


def deviation(block, line):
    """Relative, from the curve at the sigma_bar that the finite number of junctions has."""
    return block.mu_bar_eff / np.interp(block.sigma_bar, *line) - 1


def types_by_seed(fronts, grid):
    """{seed: {grid point of Figure 4 D: type}}"""
    at_grid = {place: fronts[place] for place in grid}
    return {seed: types_of(map_of_seed(at_grid, seed)) for seed in seeds_of(at_grid)}


def strata_of(points):
    """sigma_bar of slow and of fast points by stratum. `points`: (stratum, sigma_bar, kind)."""
    return [
        tuple([s for of, s, k in points if (of, k) == (stratum, kind)] for kind in KINDS)
        for stratum in sorted({of for of, *_ in points})
    ]


def map_strata(types):
    """Of grid points, by tau_bar_0."""
    return strata_of([(*place, kind) for place, kind in sorted(types.items())])


TESTS = {"van Elteren": van_elteren, "permutation": permutation}


def block_strata(blocks, width):
    """Of blocks beyond the loading zone, by bins of tau_bar_0."""
    return strata_of([(np.floor(b.tau_bar_0 / width), b.sigma_bar, b.kind) for b in blocks])


def shares_of(events, width=BINS[0]):
    """{event: share of its pairs of a slow and a fast block in which the slow one has the lower
    sigma_bar}"""
    shares = {name: share_of_lower(block_strata(of, width)) for name, of in events.items()}
    return {event: share for event, share in shares.items() if share is not None}


# --- picture -------------------------------------------------------------------------------


def draw_kind(axes, kind, colour, blocks=(), **look):
    """Without blocks, for the legend."""
    x, y = ([getattr(b, q) for b in blocks if b.kind == kind] for q in ("sigma_bar", "mu_bar_eff"))
    face = "none" if kind == "loading zone" else colour
    axes.plot(x, y, MARKERS[kind], color=colour, markerfacecolor=face, markersize=3.2, **look)


def draw(events, points, lines, stem):
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    for shape, style in CURVES.items():
        axes.plot(*lines[shape], color=BLACK, linestyle=style, linewidth=0.8, label=shape)
    coloured = {f"event {name}": (colour, events[of]) for of, (name, colour) in SHOWN.items()}
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


# --- data and claim ------------------------------------------------------------------------


def p_over_events(events):
    """{width of the bins: p}; None with too few events."""
    shares = {width: list(shares_of(events, width).values()) for width in BINS}
    return {w: signed_rank(s) if len(s) >= FEWEST_EVENTS else None for w, s in shares.items()}


def claim_4C(maps, points, lines, ensemble):
    """`maps`: {seed: {grid point: type}}; shown is that of the first seed."""
    largest = max(abs(deviation(point, lines[point.shape])) for point in points)
    p_events = p_over_events(ensemble)

    def case(seed, test, width):
        """Prepared points and events are the same for all seeds."""
        return {
            "largest deviation of prepared points from the curves": largest,
            "p over the points of the map": TESTS[test](map_strata(maps[seed])),
            "p over the ensemble's events": p_events[width],
        }

    first, shares = min(maps), list(shares_of(ensemble).values())
    return judged(
        "4C",
        shown=case(first, **WAYS[PRIMARY]) if ensemble else None,  # else nothing is known of events
        units=units_of_seeds(maps, WAYS, case) if ensemble else None,
        measured={
            **case(first, **WAYS[PRIMARY]),
            "events with slow and fast blocks": len(shares),
            "median share of their pairs with the slow one at lower sigma_bar": (
                float(np.median(shares)) if shares else None
            ),
        },
        note="Prepared: van Elteren's test over the grid points of 4D with strata tau_bar_0; n is"
        " the number of runs, one per place. Blocks of one event are not independent: each"
        f" event gives one share, over pairs with tau_bar_0 in the same bin of {BINS[0]:g}, and n"
        " of the test over events is the number of events, the same for each seed. The permutation"
        " test shuffles slow and fast among the grid points of equal tau_bar_0. " + ABOUT_UNITS,
    )


def make(chains, results, events, fronts, grid, continued):
    """`events`: {name: point}; of the map: load_map(); of the ensemble: continued_of()."""
    shown = {name: blocks_of(events[name]["front"], events[name]["strength"]) for name in SHOWN}
    points, lines = prepared_points(chains["strength"]), lines_of(chains["strength_curves"])
    draw(shown, points, lines, results / "fig4C")
    named = [(f"prepared, {point.shape}", point) for point in points]
    named += [(event, block) for event, blocks in shown.items() for block in blocks]
    names = ["kind", "tau_bar_0", "sigma_bar", "mu_bar_eff"]
    rows = ([name, *(getattr(block, of) for of in names)] for name, block in named)
    write_table(results / "strength.csv", ["points", *names], rows)
    repeated = {
        (load, number): blocks_of(event["unmodified"], event["strength"])
        for load, events in continued.items()
        for number, event in events.items()
    }
    return [claim_4C(types_by_seed(fronts, grid), points, lines, repeated)]
