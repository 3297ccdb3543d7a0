"""Speeds of slip and of fronts, and what the history of slip says: results of our own, each with an
expectation that was fixed before (expectations.toml)."""

import tomllib
from pathlib import Path

import numpy as np
from scipy.stats import spearmanr

from claims.own_result import compared, write_own
from data.records import report, values
from data.tables import numbers, points_of, write_columns
from events.fronts import front_spans
from maps.front_map import SKIP_BELOW_X
from pictures.plotting import BLACK, BLUE, DOUBLE, SKY, VERMILION, figure, letter, save

EXPECTED = Path(__file__).with_name("expectations.toml")
SLIPPED = 1e-6  # [m], about f_thres/k_ij
X_TRIGGER = 0.0225  # [m]
FINAL, OFF = (0.7, 0.9), 0.2  # where a front has its final speed [L]; relative
SLIPS = ("slip_1", "slip_2", "slip_3", "slip_4")
FRONT, SLIP = "front speed [m/s]", "slip speed [m/s]"
SLOW, FAST = "0.1", "0.3"  # tau_bar_0
VARIED = {"M": ("mass", "slider.M"), "eta": ("damping", "slider.damping")}
KINDS = {"fast": (FAST, VERMILION), "slow": (SLOW, BLUE)}
LENGTHS = {"prestress": ("", VERMILION), "long": (", slider twice as long", BLUE)}
SPEEDS = {"fronts": (FRONT, "o"), "slip": (SLIP, "^")}


# --- measuring -----------------------------------------------------------------------------


def slip_speed(slip):
    """Mean speed of a block over SLIPPED from its rupture on [m/s]; None if it slips less."""
    time, moved, start = np.array(slip["time"]), np.array(slip["slip"]), slip["t_rupture"]
    end = np.interp(start, time, moved) + SLIPPED
    beyond = np.flatnonzero((time > start) & (moved >= end))
    if not len(beyond):
        return None
    around = slice(beyond[0] - 1, beyond[0] + 1)
    return SLIPPED / (np.interp(end, moved[around], time[around]) - start)


def spanning(points):
    """(row, report) of the points whose front spans."""
    return [
        (row, found) for row, found in points if "front" in found and front_spans(found["front"])
    ]


def pairs_of(points):
    """A row for each block that was followed, with the front that passed it."""
    for row, found in points:
        for slip in (found[name] for name in SLIPS):
            block = found["front"]["x"].index(slip["x"])
            v_c, v_slip = found["front"]["v_c"][block], slip_speed(slip)
            if v_c and v_c > 0 and v_slip:
                yield row | {"x [m]": slip["x"], FRONT: v_c, SLIP: v_slip}


def exponent(rows, of, over):
    """Of the power law between two columns; None of one value alone."""
    x, y = np.log(numbers(rows, over)), np.log(numbers(rows, of))
    return np.polyfit(x, y, 1)[0] if len(set(x)) > 1 else None


def smoothed(front):
    """Positions and speeds beyond the trigger, medians of five stencils."""
    x, v_c = np.array(front["x"]), values(front["v_c"])
    beyond = (x >= SKIP_BELOW_X) & np.isfinite(v_c)
    windows = np.lib.stride_tricks.sliding_window_view(v_c[beyond], 5)
    return x[beyond][2:-2], np.median(windows, axis=1)


def transient(front):
    """The final speed [m/s], and how far beyond the trigger the speed is off it for the last time
    [mm]."""
    x, v_c = smoothed(front)
    first, last = (part * front["L"] for part in FINAL)
    final = np.median(v_c[(x >= first) & (x <= last)])
    off = x[(x < first) & (np.abs(v_c / final - 1) > OFF)]
    return final, (off[-1] - X_TRIGGER) * 1e3 if len(off) else 0.0


def transients_of(points):
    for row, found in points:
        if row["variant"] in LENGTHS:
            final, length = transient(found["front"])
            yield row | {"final speed [m/s]": final, "transient [mm]": length}


# --- results -------------------------------------------------------------------------------


def variant(rows, name):
    return [row for row in rows if row["variant"] == name]


def proportional(pairs):
    rows = variant(pairs, "prestress")
    fronts, slips = numbers(rows, FRONT), numbers(rows, SLIP)
    low, middle, high = np.percentile(slips / fronts, (10, 50, 90))
    return {
        "blocks": len(rows),
        "decades of front speed": np.log10(fronts.max() / fronts.min()),
        "exponent of the slip speed": exponent(rows, SLIP, FRONT),
        "v_slip/v_c, median": middle,
        "v_slip/v_c, 90 % over 10 %": high / low,
    }


def varied(pairs, kind, name):
    return [row for row in variant(pairs, name) if row["tau-bar"] == KINDS[kind][0]]


def inertia(pairs):
    """eta goes with the root of slider.damping."""
    return {
        f"{kind} {what}, exponent of {name}": power * exponent(varied(pairs, kind, of), speed, over)
        for (name, (of, over)), power in zip(VARIED.items(), (1, 2))
        for kind in KINDS
        for what, (speed, _) in SPEEDS.items()
    }


def transient_lengths(rows):
    measured = {}
    for name, (text, _) in LENGTHS.items():
        found = [row["transient [mm]"] for row in variant(rows, name)]
        measured |= {f"fronts{text}": len(found), f"median transient{text} [mm]": np.median(found)}
    return measured


def correlation(rows, quantity):
    return spearmanr(numbers(rows, quantity), numbers(rows, "mu_bar_eff")).statistic


def strength_by_slip(histories):
    """`histories`: rows by load."""
    rows = [row for found in histories.values() for row in found]
    by_load = [correlation(found, "Gini coefficient") for found in histories.values()]
    return {
        "blocks and ruptures": len(rows),
        "rank correlation": correlation(rows, "Gini coefficient"),
        "lowest of any load": min(by_load),
        "rank correlation with the slip itself": correlation(rows, "slip [m]"),
    }


# --- picture -------------------------------------------------------------------------------


def draw_pairs(axes, pairs):
    rows = variant(pairs, "prestress")
    for sigma, colour in zip(("0", "0.1", "0.2"), (BLUE, SKY, VERMILION)):
        part = [row for row in rows if row["sigma-bar"] == sigma]
        label = rf"$\bar\sigma = {sigma}$"
        axes.loglog(numbers(part, FRONT), numbers(part, SLIP), ".", color=colour, label=label)
    ends = np.array([numbers(rows, FRONT).min(), numbers(rows, FRONT).max()])
    ratio = np.median(numbers(rows, SLIP) / numbers(rows, FRONT))
    axes.loglog(ends, ratio * ends, color=BLACK, linewidth=0.8)
    axes.set(xlabel="$v_c$ [m/s]", ylabel="$v_\\mathrm{slip}$ [m/s]")
    axes.legend(loc="upper left", handletextpad=0)


def means(rows, speed, over):
    """Geometric means at each value; both relative to the middle one."""
    x = np.unique(numbers(rows, over))
    mean = [np.log(numbers(rows, speed))[numbers(rows, over) == value].mean() for value in x]
    return x / x[1], np.exp(mean - mean[1])


def draw_varied(axes, pairs):
    for kind, (_, colour) in KINDS.items():
        for what, (speed, marker) in SPEEDS.items():
            x, y = means(varied(pairs, kind, "mass"), speed, "slider.M")
            axes.loglog(x, y, marker, color=colour, label=f"{kind} {what}, $M$")
            x, y = means(varied(pairs, kind, "damping"), speed, "slider.damping")
            style = {"markerfacecolor": "none", "label": f"{kind} {what}, $\\eta$"}
            axes.loglog(np.sqrt(x), y, marker, color=colour, **style)
    factors = np.array([0.5, 2])
    for power in (0, -0.5):
        axes.loglog(factors, factors**power, color=BLACK, linewidth=0.8, zorder=0)
    axes.set(xlabel="$M$ or $\\eta$, relative", ylabel="speed, relative", ylim=(0.5, 3))
    axes.set_xticks([0.5, 1, 2], ["0.5", "1", "2"])
    axes.set_yticks([0.5, 1, 2], ["0.5", "1", "2"])
    axes.minorticks_off()
    axes.legend(loc="upper right", ncols=2, handletextpad=0, columnspacing=0.5)


def draw_transients(axes, points):
    for row, found in points:
        if row["variant"] in LENGTHS and row["sigma-bar"] == "0.1":
            x, v_c = smoothed(found["front"])
            _, colour = LENGTHS[row["variant"]]
            axes.semilogy(x * 1e3, v_c, color=colour, linewidth=0.6)
    axes.set(xlabel="$x$ [mm]", ylabel="$v_c$ [m/s]", xlim=(0, None))


def draw_strength(axes, rows):
    x, y = numbers(rows, "Gini coefficient"), numbers(rows, "mu_bar_eff")
    axes.plot(x, y, ".", color=SKY, markersize=1.5)
    edges = np.percentile(x, np.linspace(0, 100, 11))
    parts = [(x >= low) & (x <= high) for low, high in zip(edges, edges[1:])]
    axes.plot([np.median(x[p]) for p in parts], [np.median(y[p]) for p in parts], "o-", color=BLACK)
    axes.set(xlabel="Gini coefficient of the slip", ylabel="$\\bar\\mu_s^\\mathrm{eff}$")


def draw(pairs, points, rows, stem):
    fig, panels = figure(DOUBLE, 0.75 * DOUBLE, nrows=2, ncols=2)
    draw_pairs(panels[0, 0], pairs)
    draw_varied(panels[0, 1], pairs)
    draw_transients(panels[1, 0], points)
    draw_strength(panels[1, 1], rows)
    for axes, text in zip(panels.flat, "ABCD"):
        letter(axes, text)
    save(fig, stem)


def make(data, results):
    points = spanning(points_of(data / "speeds/fronts.csv"))
    pairs, transients = list(pairs_of(points)), list(transients_of(points))
    histories = {path.stem: report(path) for path in sorted(data.glob("speeds/*-history.json"))}
    rows = [{"load": load, **row} for load, found in histories.items() for row in found]
    draw(pairs, points, rows, results / "speeds")
    values_of = [
        "variant",
        "tau-bar",
        "sigma-bar",
        "numerics.seed",
        "slider.L",
        "slider.M",
        "slider.damping",
    ]
    write_columns(results / "speeds.csv", [*values_of, "x [m]", FRONT, SLIP], pairs)
    names = [*values_of, "final speed [m/s]", "transient [mm]"]
    write_columns(results / "transients.csv", names, transients)
    write_columns(results / "gini.csv", list(rows[0]), rows)
    measured = {
        "proportional": proportional(pairs),
        "inertia": inertia(pairs),
        "transient": transient_lengths(transients),
        "gini": strength_by_slip(histories),
    }
    expected = tomllib.loads(EXPECTED.read_text(encoding="utf-8"))
    write_own(results, [compared(name, of, **expected[name]) for name, of in measured.items()])
    return []
