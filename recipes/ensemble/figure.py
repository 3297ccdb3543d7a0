#!/usr/bin/env python3
"""The ensemble, its picture and tables:

    figure.py results/data results/ensemble run-02-events.json ...

Reads the events of each seed, and the claims about the event of each seed that has one
(events/event_claims.py); compares them with the event that the figures show.
"""

import json
import re
import sys
from dataclasses import asdict, astuple, dataclass
from pathlib import Path

import numpy as np
from scipy.stats import beta

from claims.claim import read_claims, split_unit, write_claims
from data.records import report, values
from data.tables import write_table
from events.choose_events import read_events
from events.event_claims import all_claims, is_fast_slow_fast
from events.fronts import counted, has_slow_stretch, is_fast_only, slows_down
from pictures.plotting import BLACK, BLUE, DOUBLE, SKY, VERMILION, figure, letter, save

SHOWN = "fast-slow-fast"
TESTED = ("3A", "3B", "3C", "4AB", "5A")  # claims about an event's continuations

SLOW_STRETCH = {  # quantity [unit]: of an event with a slow stretch
    "slow speed [m/s]": lambda event: event["slow"]["speed"],
    "c_s/slow speed": lambda event: event["c_s"] / event["slow"]["speed"],
    "duration [ms]": lambda event: event["slow"]["duration"] * 1e3,
    "from [L]": lambda event: event["slow"]["x_from"] / event["L"],
    "to [L]": lambda event: event["slow"]["x_to"] / event["L"],
    "fast before [m/s]": lambda event: event["slow"]["fast_before"],
    "fast after [m/s]": lambda event: event["slow"]["fast_after"],
}
KINDS = {  # share of the spanning events that ...: (claim, which)
    "share of events with a slow stretch": ("2A", has_slow_stretch),
    "share of events that slow down": ("2A", slows_down),
    "share of events that meet all of 2A": ("2A", is_fast_slow_fast),
    "share of events that are fast everywhere": ("2B", is_fast_only),
}

QUASISTATIC = {  # quantity as claim 5B names it: as quasistatic_seeds.py does
    "mean speed [m/s]": "speed",
    "c_s/speed": "c_s/speed",
    "blocks in 20 ms, V = 0": "stopped",
}


@dataclass(frozen=True)
class Quantity:
    """How one quantity is distributed over the ensemble, beside the event that the figures show.
    For a share, p5 and p95 bound it as far as n events tell (Jeffreys interval)."""

    id: str
    quantity: str
    unit: str
    n: int
    median: float
    p5: float
    p95: float
    single: float | None


def distribution(claim_id, name, numbers, single):
    p5, median, p95 = map(float, np.percentile(numbers, (5, 50, 95)))
    quantity, unit = split_unit(name)
    return Quantity(claim_id, quantity, unit, len(numbers), median, p5, p95, single)


def share(claim_id, name, hits, single):
    n, k = len(hits), sum(hits)
    p5, p95 = map(float, beta.ppf((0.05, 0.95), k + 0.5, n - k + 0.5))
    return Quantity(claim_id, name, "", n, k / n, p5, p95, single)


def event_quantities(events, shown):
    """Of all events that count."""
    rows = [
        share(claim_id, name, [is_kind(event) for event in events], None)
        for name, (claim_id, is_kind) in KINDS.items()
    ]
    slow = [event for event in events if has_slow_stretch(event)]
    for name, of in SLOW_STRETCH.items():
        numbers = [of(event) for event in slow if of(event) is not None]
        rows.append(distribution("2A", name, numbers, of(shown)))
    return rows


def is_number(value):
    return isinstance(value, (float, np.floating)) and np.isfinite(value)


def claim_quantities(claims_of_events, claims_of_shown):
    """Of the chosen event of each seed and its continuations."""
    rows = []
    for claim_id in TESTED:
        claims = [claims[claim_id] for claims in claims_of_events]
        shown = claims_of_shown[claim_id]
        accepted = [claim.shown is True for claim in claims]
        rows.append(
            share(claim_id, "share of seeds for which it holds", accepted, shown.shown is True)
        )
        for name, single in shown.measured.items():
            numbers = [c.measured[name] for c in claims if is_number(c.measured[name])]
            if is_number(single) and numbers:
                rows.append(distribution(claim_id, name, numbers, float(single)))
    return rows


def quasistatic_quantities(seeds, shown):
    """Of claim 5B: `seeds` from fig5/quasistatic_seeds.py, `shown` the claim of the shown run."""
    holds = [seed["holds"] for seed in seeds]
    rows = [share("5B", "share of seeds for which it holds", holds, shown.shown is True)]
    for name, key in QUASISTATIC.items():
        numbers = [seed[key] for seed in seeds]
        rows.append(distribution("5B", name, numbers, float(shown.measured[name])))
    return rows


def by_id(claims):
    return {claim.id: claim for claim in claims}


# --- picture -------------------------------------------------------------------------------


def colour_of(event):
    if slows_down(event):
        return BLUE
    return VERMILION if is_fast_only(event) else SKY


def draw_rupture_lines(axes, events):
    labels = {BLUE: "slows down", SKY: "other slow stretch", VERMILION: "fast only"}
    for event in sorted(events, key=lambda event: list(labels).index(colour_of(event))):
        t_rupture = values(event["t_rupture"])
        x = np.linspace(0, 1, len(t_rupture))
        colour = colour_of(event)
        time = (t_rupture - event["t_start"]) * 1e3
        axes.plot(x, time, color=colour, linewidth=0.6, label=labels.pop(colour, None))
    axes.set(xlabel="$x/L$", ylabel="block ruptures after [ms]", xlim=(0, 1), ylim=(0, None))
    axes.legend(loc="upper left")


def draw_strip(axes, columns, bounds):
    """Columns {label: (numbers of the ensemble, the shown event's)}, and what is accepted."""
    for at, (numbers, shown) in enumerate(columns.values()):
        spread = np.linspace(-0.25, 0.25, len(numbers)) if len(numbers) > 1 else [0]
        axes.plot(at + np.array(spread), sorted(numbers), ".", color=BLUE)
        axes.plot(at, shown, "D", color=BLACK, markersize=4, markerfacecolor="none")
    for bound in bounds:
        axes.axhline(bound, color=VERMILION, linestyle="--", linewidth=0.8)
    axes.set_xticks(range(len(columns)), columns, rotation=0)
    axes.set_xlim(-0.6, len(columns) - 0.4)


def draw_slow_stretch(axes, events, shown):
    slow = [event for event in events if has_slow_stretch(event)]
    for axis, name, bounds in (
        (axes[0], "slow speed [m/s]", (shown["c_s"] / 200, shown["c_s"] / 30)),
        (axes[1], "duration [ms]", (0.5, 3)),
    ):
        of = SLOW_STRETCH[name]
        draw_strip(axis, {"": ([of(event) for event in slow], of(shown))}, bounds)
        axis.set(ylabel=name, ylim=(0, None))
    ends = {
        label: ([of(event) for event in slow], of(shown))
        for label, of in (("from", SLOW_STRETCH["from [L]"]), ("to", SLOW_STRETCH["to [L]"]))
    }
    draw_strip(axes[2], ends, ())
    for at, bounds in enumerate(((0.25, 0.55), (0.5, 0.85))):
        axes[2].hlines(bounds, at - 0.4, at + 0.4, VERMILION, "--", linewidth=0.8)
    axes[2].set_ylabel("slow stretch [$L$]")


STRIPS = [  # claim, label, {column: quantity}, accepted
    ("3A", "slow speed with $V=0$/as it was", {"": "slow speed/unmodified"}, (0.75, 1.25)),
    ("3B", "arrest $-$ transition [$L$]", {"": "arrest - transition [L]"}, (-0.1, 0.1)),
    ("3C", "largest/smallest fast slip", {"": "largest/smallest fast slip"}, (1.1,)),
    (
        "3C",
        "$R^2$ of slow slip",
        {"½": "R^2 at <t_R>/2", "1": "R^2 at <t_R>", "2": "R^2 at 2<t_R>"},
        (0.95,),
    ),
    ("4AB", r"slow with wider $\varphi$ [ms]", {"": "slow stretch with the wider phi [ms]"}, ()),
    ("5A", "difference/slow duration", {"": "difference/slow duration"}, (0.05,)),
]


def draw_claims(axes, claims_of_events, claims_of_shown):
    for axis, (claim_id, label, names, bounds) in zip(axes, STRIPS):
        columns = {}
        for column, name in names.items():
            numbers = [claims[claim_id].measured[name] for claims in claims_of_events]
            shown = claims_of_shown[claim_id].measured[name]
            columns[column] = ([number for number in numbers if is_number(number)], shown)
        draw_strip(axis, columns, bounds)
        axis.set_ylabel(label)
        axis.set_title(claim_id)


def draw(events, shown, claims_of_events, claims_of_shown, stem):
    fig, axes = figure(DOUBLE, 0.62 * DOUBLE, nrows=2, ncols=6)
    lines = fig.add_subplot(axes[0, 0].get_gridspec()[0, :3])
    for axis in axes[0, :3]:
        axis.remove()
    draw_rupture_lines(lines, events)
    draw_slow_stretch(axes[0, 3:], events, shown)
    draw_claims(axes[1], claims_of_events, claims_of_shown)
    for axis, text in zip((lines, axes[0, 3], axes[1, 0]), "ABC"):
        letter(axis, text)
    save(fig, stem)


# --- tables --------------------------------------------------------------------------------


def write_quantities(path, rows):
    write_table(path, asdict(rows[0]), map(astuple, rows))


def row_of(event):
    of_slow = [of(event) if event["slow"] else None for of in SLOW_STRETCH.values()]
    kinds = ["yes" if of_kind(event) else "no" for of_kind in (slows_down, is_fast_slow_fast)]
    return [event["t_start"], event["type"], *kinds, *of_slow]


def write_events(path, events_by_seed):
    """Each event that counts; the first of a seed that slows down is its chosen one."""
    names = ["seed", "t_start [s]", "type", "slows down", "meets 2A", *SLOW_STRETCH]
    rows = ([seed, *row_of(event)] for seed, events in events_by_seed.items() for event in events)
    write_table(path, names, rows)


def summary(rows, seeds, chosen):
    """Text for the terminal."""
    lines = [f"{seeds} seeds, {chosen} with an event that slows down", ""]
    lines.append(
        f"{'claim':6}{'quantity':50}{'n':>4}{'median':>10}{'5 %':>10}{'95 %':>10}{'shown':>10}"
    )
    for row in rows:
        name = f"{row.quantity} [{row.unit}]" if row.unit else row.quantity
        shown = "" if row.single is None else f"{row.single:.4g}"
        numbers = "".join(f"{number:10.4g}" for number in (row.median, row.p5, row.p95))
        lines.append(f"{row.id:6}{name:50}{row.n:4}{numbers}{shown:>10}")
    return "\n".join(lines) + "\n"


def main(data, results, *paths):
    data, results = Path(data), Path(results)
    events_by_seed = {
        re.findall(r"run-(\d\d)-", path)[0]: counted(read_events(path)) for path in paths
    }
    events = [event for of_seed in events_by_seed.values() for event in of_seed]
    choice = report(data / "ensemble/choice.json")
    chosen = [f"ensemble/{seed}" for seed, start in choice.items() if start]
    claims_of_events = [by_id(all_claims(data, event)) for event in chosen]
    claims_of_shown = by_id(all_claims(data, SHOWN))
    shown = report(data / f"{SHOWN}-front.json")
    draw(events, shown, claims_of_events, claims_of_shown, results / "ensemble")
    rows = [
        *event_quantities(events, shown),
        *claim_quantities(claims_of_events, claims_of_shown),
        *quasistatic_quantities(
            report(data / "fig5/quasistatic-seeds.json"),
            by_id(read_claims(data / "fig5/claims-quasistatic.json"))["5B"],
        ),
    ]
    write_quantities(results / "ensemble.csv", rows)
    write_events(results / "events.csv", events_by_seed)
    text = json.dumps([asdict(row) for row in rows], indent=2, allow_nan=False)
    (results / "ensemble.json").write_text(text + "\n", encoding="utf-8")
    (results / "summary.txt").write_text(summary(rows, len(choice), len(chosen)), encoding="utf-8")
    write_claims(results / "claims.json", [])


if __name__ == "__main__":
    main(*sys.argv[1:])
