"""Speeds of slip and of fronts, and strength by the history of slip: results of our own, each with
an expectation that was fixed before (expectations.toml)."""

import tomllib
from pathlib import Path

import numpy as np
from rupture.figures import BLACK, BLUE, DOUBLE, SKY, VERMILION, lettered, save
from scipy.stats import spearmanr

from claims.own_result import compared, write_own
from measure.tables import numbers, write_columns
from speeds.commands import fronts, histories
from speeds.front_slip import FRONT, SLIP, exponent, pairs_of, smoothed, transient

# Exponents: tau_bar_0 of the fronts, speeds, and (variant, parameter, power of the quantity).
KINDS = {"fast": 0.3, "slow": 0.1}
SPEEDS = {"fronts": FRONT, "slip": SLIP}
VARIED = {"M": ("mass", "slider.M", 1), "eta": ("damping", "slider.damping", 2)}
LENGTHS = {"prestress": ("", VERMILION), "long": (", slider twice as long", BLUE)}
NAMES = "variant tau-bar sigma-bar numerics.seed slider.L slider.M slider.damping".split()
GINI, LENGTH = "Gini coefficient", "transient [mm]"
OF_SEEDS = "lowest and highest over seeds: "


def select(rows, **wanted):
    return [row for row in rows if wanted.items() <= row.items()]


def proportional(rows):
    fronts, ratios = numbers(rows, FRONT), numbers(rows, SLIP) / numbers(rows, FRONT)
    low, high = np.percentile(ratios, (10, 90))
    return {
        "blocks": len(rows),
        "decades of front speed": np.log10(fronts.max() / fronts.min()),
        "exponent of the slip speed": exponent(rows, SLIP, FRONT),
        "v_slip/v_c, median": np.median(ratios),
        "v_slip/v_c, 90 % over 10 %": high / low,
    }


def inertia(pairs, text=""):
    return {
        f"{text}{kind} {what}, exponent of {name}": power
        * exponent(select(pairs, variant=variant, **{"tau-bar": tau_bar}), speed, parameter)
        for name, (variant, parameter, power) in VARIED.items()
        for kind, tau_bar in KINDS.items()
        for what, speed in SPEEDS.items()
    }


def over_seeds(pairs):
    """The lowest and the highest exponent of any seed."""
    seeds = {row["numerics.seed"] for row in select(pairs, variant="mass")}
    of_seeds = [inertia(select(pairs, **{"numerics.seed": seed})) for seed in seeds]
    return {OF_SEEDS + n: [f(of[n] for of in of_seeds) for f in (min, max)] for n in of_seeds[0]}


def transients(rows):
    return {
        f"median transient{text} [mm]": np.median(
            [row[LENGTH] for row in select(rows, variant=name)]
        )
        for name, (text, _) in LENGTHS.items()
    }


def correlation(rows, quantity=GINI):
    return spearmanr(numbers(rows, quantity), numbers(rows, "mu_bar_eff")).statistic


def strength_by_slip(rows):
    loads = [select(rows, load=load) for load in {row["load"] for row in rows}]
    return {
        "blocks and ruptures": len(rows),
        "rank correlation": correlation(rows),
        "lowest of any load": min(map(correlation, loads)),
        "looked at afterwards: with the slip after 2 ms": correlation(rows, "slip after 2 ms [m]"),
    }


def draw_pairs(axes, rows):
    fronts, slips = numbers(rows, FRONT), numbers(rows, SLIP)
    axes.loglog(fronts, slips, ".", color=BLUE)
    axes.loglog(fronts, np.median(slips / fronts) * fronts, color=BLACK, linewidth=0.8)
    axes.set(xlabel="$v_c$ [m/s]", ylabel=r"$v_\mathrm{slip}$ [m/s]")


def draw_exponents(axes, result):
    """Bars: what was expected."""
    for place, (name, bounds) in enumerate(result.expected.items()):
        axes.plot(bounds.values(), [place] * 2, color=SKY, linewidth=5, solid_capstyle="butt")
        axes.plot(result.measured[OF_SEEDS + name], [place] * 2, color=BLACK)
        axes.plot(result.measured[name], place, "o", color=BLACK, markersize=2.5)
    names = [name.replace("exponent of ", "") for name in result.expected]
    axes.set_yticks(range(len(names)), names)
    axes.set(xlabel="exponent", ylim=(len(result.expected) - 0.5, -0.5))


def draw_transients(axes, rows):
    for row in rows:
        x, v_c = smoothed(row["front"])
        axes.semilogy(x * 1e3, v_c, color=LENGTHS[row["variant"]][1], linewidth=0.6)
    for (_, colour), label in zip(LENGTHS.values(), ("this slider", "twice as long")):
        axes.plot([], [], color=colour, label=label)
    axes.legend(loc="lower right")
    axes.set(xlabel="$x$ [mm]", ylabel="$v_c$ [m/s]", xlim=(0, None))


def draw_strength(axes, rows):
    x, y = numbers(rows, GINI), numbers(rows, "mu_bar_eff")
    axes.plot(x, y, ".", color=SKY, markersize=1.5)
    tenths = np.array_split(np.argsort(x), 10)
    axes.plot(*([np.median(v[tenth]) for tenth in tenths] for v in (x, y)), "o-", color=BLACK)
    axes.set(xlabel="Gini coefficient of the slip", ylabel=r"$\bar\mu_s^\mathrm{eff}$")


def make(results):
    pairs = list(pairs_of(fronts()))
    homogeneous = [
        row | {LENGTH: transient(front), "front": front}
        for row, front, _ in fronts()
        if row["variant"] in LENGTHS
    ]
    blocks = histories()
    near = select(pairs, **{"x [m]": 0.055})
    measured = {
        "proportional": proportional(select(pairs, variant="prestress")),
        "inertia": inertia(pairs)
        | over_seeds(pairs)
        | inertia(near, "looked at afterwards, x = 55 mm: "),
        "transient": transients(homogeneous),
        "gini": strength_by_slip(blocks),
    }
    fixed = tomllib.loads(Path(__file__).with_name("expectations.toml").read_text(encoding="utf-8"))
    own = {name: compared(name, of, **fixed[name]) for name, of in measured.items()}
    write_own(results, own.values())
    fig, panels = lettered("AB;CD", DOUBLE, 0.75 * DOUBLE)
    draw_pairs(panels["A"], select(pairs, variant="prestress"))
    draw_exponents(panels["B"], own["inertia"])
    draw_transients(panels["C"], select(homogeneous, **{"sigma-bar": 0.1}))
    draw_strength(panels["D"], blocks)
    save(fig, results / "speeds")
    write_columns(results / "speeds.csv", [*NAMES, "x [m]", FRONT, SLIP], pairs)
    write_columns(results / "transients.csv", [*NAMES, LENGTH], homogeneous)
    write_columns(results / "gini.csv", list(blocks[0]), blocks)
