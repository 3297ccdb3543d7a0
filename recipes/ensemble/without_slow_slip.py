"""Runs the fast-slow events of a load with the simplified law without slow slip:

    without_slow_slip.py RUN CHECKPOINT_EVERY OPTIONS_OF_RECORDS

RUN is results/data/ensemble/simplified-01. An event counts if it is fast-slow under any
convention. Prints, by the events' numbers, {convention: {"with", "without"}}: the event, and the
front without slow slip, null where nothing ruptures.
"""

from pathlib import Path

from workshop import Workshop, without_lines

from data.records import report
from data.scratch import scratch
from events.continuations import WITHOUT_SLOW_SLIP
from events.conventions import CONVENTIONS, PRIMARY
from events.fronts import is_fast_slow


def same_event(event, events):
    """Of `events`, measured in another way, the one at the same time; None if there is none."""
    beginning, end = event["t_start"], event["t_end"]
    return next((e for e in events if e["t_start"] <= end and e["t_end"] >= beginning), None)


def events_by_convention(lists):
    """Pairs of an event's number and {convention: event}, the primary one first."""
    for event in lists[PRIMARY]:
        yield event["number"], {name: same_event(event, lists[name]) for name in CONVENTIONS}


def measure(workshop, by_convention):
    """`by_convention`: one event."""
    workshop.start(by_convention[PRIMARY])
    workshop.recorded(workshop.path("start"), "without", *WITHOUT_SLOW_SLIP.split())
    without = workshop.fronts("without", CONVENTIONS)
    return {
        name: {"with": without_lines(event), "without": without_lines(without[name])}
        for name, event in by_convention.items()
    }


def main(run, *options):
    chosen = {
        number: by_convention
        for number, by_convention in events_by_convention(report(f"{run}-events.json"))
        if any(is_fast_slow(event) for event in by_convention.values() if event)
    }
    with scratch(Path(f"{run}-scratch")) as folder:
        workshop = Workshop(run, *options, folder)
        return {number: measure(workshop, event) for number, event in chosen.items()}
