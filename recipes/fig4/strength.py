"""Figure 4 C, its data and claim 4C."""

from dataclasses import dataclass

import numpy as np

from claims.judge import judged
from data.rank_test import permutation, share_of_lower, signed_rank, van_elteren
from data.records import report, values
from data.tables import read_rows, write_table
from events.conventions import PRIMARY
from events.fronts import LOADING_ZONE, SLOW_BELOW
from events.units import of_ensemble
from maps.front_map import load_map, map_of_seed, seeds_of, type_on_map, types_of
from maps.map_conventions import ABOUT_UNITS, units_of_seeds
from pictures.plotting import BLACK, GREEN, SINGLE, VERMILION, figure, letter, save

SHOWN = {"fast-slow-fast": ("I", GREEN), "second-slow": ("II", VERMILION)}
BINS = (0.1, 0.05, 0.2)  # of tau_bar_0: blocks in one bin count as equally loaded; primary first
WAYS = {
    PRIMARY: {"test": "van Elteren", "width": BINS[0]},
    **{f"bins of {width:g}": {"test": "van Elteren", "width": width} for width in BINS[1:]},
    "permutation test": {"test": "permutation", "width": BINS[0]},
}
MARKERS = {"slow": ".", "fast": "x", "loading zone": "o", "arrested": "+"}
CURVES = {"uniform": "-", "bell": "--"}
FEWEST_EVENTS = 5  # for a test over events
KINDS = ("slow", "fast")
QUANTITIES = ("tau_bar_0", "sigma_bar", "mu_bar_eff")


@dataclass(frozen=True)
class Block:
    kind: str  # slow, fast, or loading zone
    sigma_bar: float
    tau_bar_0: float
    mu_bar_eff: float


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
    return [Block(kind, *numbers) for kind, numbers in zip(kinds, quantities) if kind]


def prepared_points(data):
    """Prepared interfaces: rows with numbers, without those that cannot be prepared."""
    for row in read_rows(data / "fig4/strength.csv"):
        if row["status"] == "done":
            yield {
                "shape": row["shape"],
                "type": type_on_map(row["type"]),
                "tau_bar_0": float(row["tau-bar"]),
                "sigma_bar": float(row["sigma_bar in the middle"]),
                "mu_bar_eff": float(row["mu_bar_eff in the middle"]),
            }


def curves(data):
    """{shape: {sigma_bar: mu_bar_eff}}"""
    lines: dict[str, dict] = {shape: {} for shape in CURVES}
    for row in read_rows(data / "fig4/strength-curves.csv"):
        lines[row["shape"]][float(row["sigma-bar"])] = float(row["mu_bar_eff"])
    return lines


# --- tests ---------------------------------------------------------------------------------


def strength_of(line, sigma_bar):
    return np.interp(sigma_bar, *np.array(sorted(line.items())).T)


def deviations(points, lines):
    """Relative, from the curve at the sigma_bar that the finite number of junctions has."""
    for point in points:
        yield point["mu_bar_eff"] / strength_of(lines[point["shape"]], point["sigma_bar"]) - 1


def from_nearest_curve(block, lines):
    """Relative deviation of one block from the nearer of the two curves."""
    strengths = [strength_of(line, block.sigma_bar) for line in lines.values()]
    return min(abs(block.mu_bar_eff / strength - 1) for strength in strengths)


def types_by_seed(data):
    """{seed: {grid point of Figure 4 D: type}}"""
    fronts, grid, _ = load_map(data, "fig4", ["map-between", "map-boundary"])
    at_grid = {place: fronts[place] for place in grid}
    return {seed: types_of(map_of_seed(at_grid, seed)) for seed in seeds_of(at_grid)}


def map_strata(types):
    """sigma_bar of slow and of fast grid points, by tau_bar_0."""
    return [
        tuple([s for (t, s), k in sorted(types.items()) if (t, k) == (tau, kind)] for kind in KINDS)
        for tau in sorted({tau for tau, _ in types})
    ]


def p_of_van_elteren(strata):
    return (van_elteren(strata) or {"p": None})["p"]


TESTS = {"van Elteren": p_of_van_elteren, "permutation": permutation}


def block_strata(blocks, width):
    """sigma_bar of slow and of fast blocks beyond the loading zone, by bins of tau_bar_0."""
    bins = {np.floor(block.tau_bar_0 / width) for block in blocks}
    for number in sorted(bins):
        inside = [b for b in blocks if np.floor(b.tau_bar_0 / width) == number]
        yield tuple([b.sigma_bar for b in inside if b.kind == kind] for kind in KINDS)


def shares_of(events, width=BINS[0]):
    """{event: share of its pairs of a slow and a fast block in which the slow one has the lower
    sigma_bar}"""
    shares = {
        event: share_of_lower(list(block_strata(blocks, width))) for event, blocks in events.items()
    }
    return {event: share for event, share in shares.items() if share is not None}


# --- picture -------------------------------------------------------------------------------


def draw_markers(axes, kind, colour, points):
    x, y = zip(*points)
    hollow = {"markerfacecolor": "none"} if kind == "loading zone" else {}
    axes.plot(
        x,
        y,
        MARKERS[kind],
        color=colour,
        markersize=3.2,
        linestyle="none",
        markeredgewidth=0.7,
        **hollow,
    )


def draw_events(axes, events):
    for event, blocks in events.items():
        for kind in ("loading zone", "fast", "slow"):
            points = [(b.sigma_bar, b.mu_bar_eff) for b in blocks if b.kind == kind]
            if points:
                draw_markers(axes, kind, SHOWN[event][1], points)


def draw_prepared(axes, points):
    for kind in ("arrested", "fast", "slow"):
        chosen = [(p["sigma_bar"], p["mu_bar_eff"]) for p in points if p["type"] == kind]
        if chosen:
            draw_markers(axes, kind, BLACK, chosen)


def draw_curves(axes, lines):
    for shape, style in CURVES.items():
        axes.plot(*zip(*sorted(lines[shape].items())), color=BLACK, linestyle=style, linewidth=0.8)


def draw_legend(axes, events):
    for shape, style in CURVES.items():
        axes.plot([], [], color=BLACK, linestyle=style, linewidth=0.8, label=shape)
    for kind, marker in MARKERS.items():
        axes.plot(
            [],
            [],
            marker,
            color="grey",
            markersize=3.2,
            markerfacecolor=("none" if kind == "loading zone" else "grey"),
            label=kind,
        )
    for event in events:
        name, colour = SHOWN[event]
        axes.plot([], [], "s", color=colour, label=f"event {name}")
    axes.plot([], [], "s", color=BLACK, label="prepared")
    axes.legend(loc="lower left", handlelength=1.6)


def draw(events, points, lines, stem):
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    draw_curves(axes, lines)
    draw_events(axes, events)
    draw_prepared(axes, points)
    draw_legend(axes, events)
    axes.set(xlabel=r"$\bar\sigma$", ylabel=r"$\bar\mu_s^\mathrm{eff}$")
    axes.set(xlim=(-0.02, 0.6), ylim=(0, 1.05))
    letter(axes, "C")
    save(fig, stem)


# --- data and claim ------------------------------------------------------------------------


def rows(events, points):
    for point in points:
        yield [f"prepared, {point['shape']}", point["type"], *(point[q] for q in QUANTITIES)]
    for event, blocks in events.items():
        for block in blocks:
            yield [event, block.kind, *(getattr(block, q) for q in QUANTITIES)]


def measure_map(types):
    strata = map_strata(types)
    both = [(slow, fast) for slow, fast in strata if slow and fast]
    return {
        "rows of the map with slow and fast points": len(both),
        "slow points in them": sum(len(slow) for slow, _ in both),
        "fast points in them": sum(len(fast) for _, fast in both),
        "share of slow-fast pairs with the slow one at lower sigma_bar": share_of_lower(strata),
        **{f"{name} p": test(strata) for name, test in TESTS.items()},
    }


def p_over_events(events, width):
    """None with too few events."""
    shares = list(shares_of(events, width).values())
    return signed_rank(shares) if len(shares) >= FEWEST_EVENTS else None


def measure_events(shown, ensemble, lines):
    shares = list(shares_of(ensemble).values())
    beyond = [b for blocks in shown.values() for b in blocks if b.kind != "loading zone"]
    return {
        "blocks beyond the loading zone": len(beyond),
        "their median deviation from the nearer curve": float(
            np.median([from_nearest_curve(block, lines) for block in beyond])
        ),
        **{
            f"share of such pairs of blocks, event {SHOWN[event][0]}": share
            for event, share in shares_of(shown).items()
        },
        "ensemble events with slow and fast blocks": len(shares),
        "share of such pairs of blocks, median of the ensemble": float(np.median(shares))
        if shares
        else None,
        "share of such pairs of blocks, 5-95 % of the ensemble": (
            np.percentile(shares, [5, 95]).tolist() if shares else None
        ),
        **{
            f"signed-rank p over the ensemble's events, bins of {width:g}": p_over_events(
                ensemble, width
            )
            for width in BINS
        },
    }


def case_4C(types, deviation, p_events, *, test, width):
    """Of the map of one seed; the prepared points and the events are the same for all of them."""
    return {
        "largest deviation of prepared points from the curves": deviation,
        "p over the points of the map": TESTS[test](map_strata(types)),
        "p over the ensemble's events": p_events[width],
    }


def claim_4C(maps, points, lines, shown, ensemble):
    """`maps`: {seed: {grid point: type}}; shown is that of the first seed."""
    deviation = max(abs(each) for each in deviations(points, lines))
    p_events = {width: p_over_events(ensemble, width) for width in BINS}

    def case(seed, **way):
        return case_4C(maps[seed], deviation, p_events, **way)

    first = min(maps)
    return judged(
        "4C",
        shown=case(first, **WAYS[PRIMARY]) if ensemble else None,  # else nothing is known of events
        units=units_of_seeds(maps, WAYS, case) if ensemble else None,
        measured={
            "prepared points": len(points),
            "largest deviation of prepared points from the curves": deviation,
            **measure_map(maps[first]),
            **measure_events(shown, ensemble, lines),
        },
        note="Prepared: van Elteren's test over the grid points of 4D with strata tau_bar_0; n is"
        " the number of runs, one per place. Blocks of one event are no independent points: each"
        f" event gives one share, over pairs with tau_bar_0 in the same bin of {BINS[0]:g}, and n"
        " of the test over events is the number of events, the same for each seed. The permutation"
        " test hands out slow and fast anew among the grid points of equal tau_bar_0. "
        + ABOUT_UNITS,
    )


def make(data, results):
    shown = {
        event: blocks_of(*(report(data / f"{event}-{of}.json") for of in ("front", "strength")))
        for event in SHOWN
    }
    points, lines = list(prepared_points(data)), curves(data)
    draw(shown, points, lines, results / "fig4C")
    write_table(results / "strength.csv", ["points", "kind", *QUANTITIES], rows(shown, points))
    repeated = {
        (path, number): blocks_of(event["unmodified"], event["strength"])
        for path in of_ensemble(data, "load", "continued")
        for number, event in report(path).items()
    }
    return [claim_4C(types_by_seed(data), points, lines, shown, repeated)]
