#!/usr/bin/env python3
"""Exponential slipping times, events and claim:

    exponential.py EVENTS.json FRONT.json FRONT_WITH_EXPONENTIAL_TIMES.json FOLDER CLAIMS.json
"""

import sys
from pathlib import Path

import numpy as np

from claims.claim import Claim, verdict, write_claims
from data.records import report, values
from data.tables import write_table
from events.choose_events import read_events
from events.fronts import criteria_2A, has_slow_stretch, is_fast_only, is_fast_slow_fast
from pictures.plotting import BLUE, DOUBLE, VERMILION, figure, save

NOTE = (
    "Slow stretches are as slow as in the reference run, but begin next to the loading zone: no"
    " fast front precedes them. The interface that earlier events leave differs, not the front:"
    " the event of Figure 2 is also continued with exponential times, from the moment when"
    " its front is at 0.14 L. The verdict is that of the run with exponential times throughout."
)
COLUMNS = ["x_from", "x_to", "duration", "speed", "fast_before", "fast_after"]


def draw(events, stem):
    """When each block ruptures: one small panel per spanning event."""
    fig, axes = figure(DOUBLE, 0.25 * DOUBLE, ncols=len(events), sharex=True, sharey=True)
    for event, axis in zip(events, axes):
        t_rupture = values(event["t_rupture"])
        time = (t_rupture - event["t_start"]) * 1e3
        colour = VERMILION if is_fast_only(event) else BLUE
        axis.plot(np.linspace(0, 1, len(time)), time, ".", color=colour)
        axis.set(title=f"{event['t_start']:.3f} s", xlim=(0, 1), ylim=(0, None))
        axis.set_xticks([0, 0.5, 1], ["0", "½", "1"])
        axis.set_xlabel("$x/L$")
    axes[0].set_ylabel("block ruptures after [ms]")
    save(fig, stem)


def row_of(event):
    slow = event["slow"]
    numbers = [slow[column] if slow else None for column in COLUMNS]
    unmet = [name for name, met in criteria_2A(event).items() if not met] if slow else []
    return [event["t_start"], event["type"], *numbers, "; ".join(unmet)]


def write_events(path, events):
    names = ["t_start [s]", "type", *COLUMNS, "criteria of 2A not met"]
    write_table(path, names, map(row_of, events))


def closest(events):
    """The event that meets most criteria of claim 2A, the first of several."""
    return max(filter(has_slow_stretch, events), key=lambda event: sum(criteria_2A(event).values()))


def slow_stretch(front):
    """In one line; a front without one is what it is."""
    slow, L = front["slow"], front["L"]
    if slow is None:
        return f"none, the front is {front['type']}"
    where = f"{slow['x_from'] / L:.3g} L to {slow['x_to'] / L:.3g} L"
    return f"{slow['speed']:.3g} m/s for {slow['duration'] * 1e3:.3g} ms, {where}"


def claim_Exp(events, unmodified, continued):
    accepted = [event for event in events if is_fast_slow_fast(event)]
    shown = accepted[0] if accepted else closest(events)
    slow, L = shown["slow"], shown["L"]
    unmet = [name for name, met in criteria_2A(shown).items() if not met]
    return Claim(
        id="Exp",
        paper="exponential T(t_R): qualitatively similar",
        measured={
            "spanning events": len(events),
            "with a slow stretch": sum(map(has_slow_stretch, events)),
            "meeting 2A": len(accepted),
            "first to meet most of 2A at [s]": shown["t_start"],
            "slow speed [m/s]": slow["speed"],
            "duration [ms]": slow["duration"] * 1e3,
            "from [L]": slow["x_from"] / L,
            "to [L]": slow["x_to"] / L,
            "fast before [m/s]": slow["fast_before"],
            "fast after [m/s]": slow["fast_after"],
            "unmet criteria": ", ".join(unmet) or "none",
            "slow stretch of the event of Figure 2": slow_stretch(unmodified),
            "the same, continued with exponential times": slow_stretch(continued),
            "which meets 2A": "yes" if is_fast_slow_fast(continued) else "no",
        },
        acceptance="2A holds with exponential t_R of the same mean",
        verdict=verdict(bool(accepted)),
        note="" if accepted else NOTE,
    )


def main(events, unmodified, continued, results, claims):
    results = Path(results)
    spanning = [event for event in read_events(events) if event["spanning"]]
    draw(spanning, results / "exponential")
    write_events(results / "exponential-events.csv", spanning)
    write_claims(claims, [claim_Exp(spanning, report(unmodified), report(continued))])


if __name__ == "__main__":
    main(*sys.argv[1:])
