"""Fronts under choices that the paper leaves open, a result of our own."""

import textwrap
from dataclasses import astuple, dataclass, replace

import numpy as np
from rupture.figures import BLACK, BLUE, DOUBLE, VERMILION, figure, letter, save

import paper
from choices.commands import CHOICES, DECAYING, SETTLED, SIGMA_BARS, edges, runs
from choices.commands import samples_of_branches, samples_of_runs
from claims.judge import by_way, interval_of, shares_of
from claims.own_result import OwnResult, write_own
from claims.recipes import function_of
from claims.resampling import interval_by_runs
from claims.table import table
from event_numbers import numbers_of
from measure.ways import PRIMARY
from measure.fronts import is_fast_only
from measure.tables import write_table

OF_RUNS, OF_BRANCHES = ("2A", "2B", "2C"), ("3A", "3B", "4AB")
ROWS = {  # claims that are judged under each choice
    "reference": (*OF_RUNS, *OF_BRANCHES),
    "decaying": ("S6A",),
}
ALIKE = {"2A": "S6A"}  # in the same panel
SHARE = "share in words"  # fast-slow-fast, of the spanning events
MEDIANS = {  # of fast-slow-fast events, by quantities of numbers_of()
    "fast/c_s": "fast before/c_s",
    "slowest/c_s": "slowest/c_s",
    "mean slow/c_s": "mean slow speed/c_s",
    "begins/L": "from [L]",
    "ends/L": "to [L]",
    "lasts/ms": "duration [ms]",
}
FAST_ONLY = "fast only/c_s"  # of events that are fast everywhere
SLOW = {f"slow at sigma {sigma}": sigma for sigma in SIGMA_BARS}
SHARES = (*ROWS["reference"], SHARE, *ROWS["decaying"])
NUMBERS = (*MEDIANS, FAST_ONLY)
PAPER = {
    "fast/c_s": paper.FAST,
    "slowest/c_s": paper.SLOW,
    "begins/L": paper.TRANSITIONS[0],
    "ends/L": paper.TRANSITIONS[1],
    "lasts/ms": paper.SLOW_FOR * 1e3,
}
RANGE = (5, 95)  # [%] of the events
HEADS = ("choice", "quantity", "value", "from", "to", "n", *(f"{p} %" for p in RANGE), "moved")
RULE = "its 90 % interval and that of the model as settled do not overlap"


@dataclass(frozen=True)
class Found:
    """A share or a median: its 90 % interval, of how many samples or events, and between which
    values most of the events behind a median lie. A band of slow fronts has nothing but its ends.
    `moved`: "up", "down" or "" (not); None if there is nothing to compare with."""

    value: float | None
    low: float | None
    high: float | None
    n: int | None = None
    least: float | None = None
    most: float | None = None
    moved: str | None = None

    def beside(self, settled):
        """Compares this with what is settled, by RULE."""
        if settled is None or None in (self.value, self.low, settled.low):
            return self
        up, down = self.low > settled.high, self.high < settled.low
        return replace(self, moved="up" if up else "down" if down else "")


# --- measuring -----------------------------------------------------------------------------


def settled_of(choice):
    """What it is compared with."""
    return "decaying" if choice in DECAYING else "reference"


def median(of_runs):
    """The median of the values of all runs, their range, and the interval of the median."""
    values = [value for of in of_runs for value in of]
    least, most = np.percentile(values, RANGE)
    low, high = interval_by_runs(np.median, of_runs)
    return Found(np.median(values), low, high, len(values), least, most)


def values_of(events):
    """{quantity: its values} of the spanning events of a run. One that is slow in words and nowhere
    below c_s/20 has no slow stretch to be measured."""
    cases = [numbers_of(event) for event in events if event["fast_slow_fast"]]
    found = {name: [case[key] for case in cases] for name, key in MEDIANS.items()}
    found[FAST_ONLY] = [event["speed"] / event["c_s"] for event in events if is_fast_only(event)]
    return {name: [value for value in of if value is not None] for name, of in found.items()}


def of_spanning(runs):
    """Quantities of spanning events; `runs`: those of each."""
    words = [[event["fast_slow_fast"] for event in events] for events in runs]
    found = {}
    if n := sum(map(len, words)):
        low, high = interval_of(words)
        found[SHARE] = Found(sum(map(sum, words)) / n, low, high, n)
    values = [values_of(events) for events in runs]
    return found | {
        name: median([of[name] for of in values])
        for name in NUMBERS
        if any(of[name] for of in values)
    }


def bands():
    """{choice: bands of slow fronts on prepared interfaces, between bisected edges}"""
    found: dict[str, dict] = {choice: {} for choice in CHOICES}
    names = {sigma: name for name, sigma in SLOW.items()}
    for (choice, sigma), of in edges().items():
        found[choice][names[sigma]] = Found(None, of[PRIMARY]["slow"], of[PRIMARY]["fast"])
    return found


def share_of(claim, choice):
    """[share] of the runs or branches of a choice for which a claim holds, in the primary way."""
    row = table()[claim] | {"ways": ()}
    taken = samples_of_branches(choice) if claim in OF_BRANCHES else samples_of_runs(choice)
    measured = function_of(row["recipe"], row["measured"])
    return shares_of(row, by_way(row, measured, taken))


def measured(choice):
    """{quantity: what was found}, of what there is."""
    shares = {
        claim: Found(share.part(), share.low, share.high, share.samples)
        for claim in ROWS[settled_of(choice)]
        for share in share_of(claim, choice)
    }
    loads = (events[PRIMARY] for _, events in runs()[choice])
    return shares | of_spanning([[one for one in of if one["spanning"]] for of in loads])


def all_measured():
    """{(choice, quantity): what was found}; those as settled come first."""
    of_edges = bands()
    found: dict[tuple, Found] = {}
    for choice in CHOICES:
        for name, one in (measured(choice) | of_edges[choice]).items():
            found[choice, name] = one.beside(found.get((settled_of(choice), name)))
    return found


# --- results -------------------------------------------------------------------------------


def joined(texts, between=", "):
    return between.join(texts) or None


def own_result(found):
    def medians(choice):
        return [of and of.value for of in (found.get((choice, name)) for name in NUMBERS)]

    moved: dict[str, list] = {choice: [] for (choice, _), one in found.items() if one.moved == ""}
    for (choice, name), one in found.items():
        if one.moved:
            moved.setdefault(choice, []).append(f"{name} {one.moved}")
    most_first = sorted(moved.items(), key=lambda pair: -len(pair[1]))
    told = {
        "moved under": joined(f"{choice} ({len(what)})" for choice, what in most_first if what),
        "which choices move what": joined(
            (f"{choice}: {joined(what)}" for choice, what in moved.items() if what), "; "
        ),
        "nothing moved under": joined(choice for choice, what in moved.items() if not what),
        "a choice moves what is measured if": RULE,
        "same medians under": joined(
            choice for choice in moved if medians(choice) == medians(settled_of(choice))
        ),
        "comparisons": sum(one.moved is not None for one in found.values()),
        "moved": sum(map(len, moved.values())),
    }
    for name, sigma in SLOW.items():
        edges = [one.high for (_, of), one in found.items() if of == name]
        told[f"fast from, sigma_bar {sigma}, lowest"] = min(edges)
        told[f"fast from, sigma_bar {sigma}, highest"] = max(edges)
    question = "which choices that the paper leaves open move the fronts?"
    return OwnResult(id="choices", question=question, measured=told)


# --- picture -------------------------------------------------------------------------------


def draw_found(axes, one, y):
    colour = VERMILION if one.moved else BLUE
    axes.plot([one.least, one.most], [y, y], linewidth=0.5, color=colour)
    axes.plot([one.low, one.high], [y, y], "|-", markersize=3, linewidth=1.5, color=colour)
    axes.plot([one.value], [y], "o", markersize=2.5, color=colour)


def draw_panel(axes, found, name):
    for y, choice in enumerate(CHOICES):
        if one := found.get((choice, name)) or found.get((choice, ALIKE.get(name))):
            draw_found(axes, one, y)
            if choice in SETTLED and None not in (one.value, one.low):
                of = [y for y, other in enumerate(CHOICES) if settled_of(other) == choice]
                axes.fill_betweenx((of[0] - 0.5, of[-1] + 0.5), one.low, one.high, color="0.88")
    if name in PAPER:
        axes.axvline(PAPER[name], color=BLACK, linestyle="--", linewidth=0.8)
    axes.margins(x=0.1)
    axes.set_xlim(*(-0.05, 1.05) if name in SHARES else (0, None))
    axes.locator_params("x", nbins=2)
    axes.xaxis.set_major_formatter("{x:g}")
    heading = f"{name}, {ALIKE[name]}" if name in ALIKE else name
    heading = textwrap.fill(heading.replace("sigma", "σ"), 8, break_long_words=False)
    axes.set_xlabel(heading.replace("c_s", "$c_s$").replace("σ", r"$\bar\sigma$"))


def draw(found, stem):
    names = [name for name in (*SHARES, *NUMBERS, *SLOW) if name not in ALIKE.values()]
    fig, panels = figure(DOUBLE, 0.8 * DOUBLE, nrows=2, ncols=len(names) // 2, sharey=True)
    for axes, name in zip(panels.flat, names):
        draw_panel(axes, found, name)
    for axes, text in zip(panels[:, 0], "AB"):
        letter(axes, text)
    panels[0, 0].set_yticks(range(len(CHOICES)), CHOICES)
    panels[0, 0].invert_yaxis()
    save(fig, stem)


def make(results):
    found = all_measured()
    draw(found, results / "choices")
    write_table(results / "choices.csv", HEADS, ((*key, *astuple(f)) for key, f in found.items()))
    write_own(results, [own_result(found)])
