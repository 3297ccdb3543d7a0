"""The record that a program draws, and the time window."""

from functools import partial

import numpy as np

from rupture.errors import Failure
from rupture.files import Record, open_file
from rupture.tools.command_line import UsageError, whole_number

MARGIN = 0.15  # shown before and after an event, of its duration
LEAST_MARGIN = 0.5e-3  # [s]
FIRST_SPANNING = "first-spanning"


def add_window(parser):
    text = "show this event of rupture analyze events, or the first that spans the interface"
    number = partial(whole_number, least=0, words=(FIRST_SPANNING,))
    parser.add_argument("--event", type=number, metavar=f"number|{FIRST_SPANNING}", help=text)
    parser.add_time("--from", "start at this time", dest="begin")
    parser.add_time("--to", "end at this time", dest="end")


def open_record(path):
    record = open_file(path)
    if not isinstance(record, Record):
        raise Failure(f"{path} is a checkpoint; give a record")
    if len(record.time) < 2:
        raise Failure(f"{path} has fewer than two samples; wait until its run has written more")
    return record


def last_rupture(event):
    """The last rupture of an event, as far as the record shows it [s]. If the event is not over,
    blocks that rupture again do not count."""
    if event["t_end"] is not None:
        return event["t_end"]
    return max(t for t in (*event["t_rupture"], event["t_start"]) if t is not None)


def window_of_event(events, number):
    """[s], [s]"""
    if number == FIRST_SPANNING:
        number = next((n for n, event in enumerate(events) if event["spanning"]), None)
    if number is None:
        raise Failure("no event in the record spans the interface: give --event N")
    if number >= len(events):
        known = f"{len(events)} events, numbers 0 to {len(events) - 1}"
        has = {0: "no events", 1: "1 event, number 0"}.get(len(events), known)
        raise UsageError(f"there is no event {number}: the record has {has}")
    start, end = events[number]["t_start"], last_rupture(events[number])
    margin = max(MARGIN * (end - start), LEAST_MARGIN)
    return start - margin, end + margin


def asked_window(options, first, last):
    """The window of --from and --to in a record from `first` to `last` [s], [s]."""
    begin = first if options.begin is None else options.begin
    end = last if options.end is None else options.end
    record = f"the record, which goes from {first:.7g} s to {last:.7g} s"
    if begin > last:
        raise UsageError(f"--from {begin:g} is outside {record}")
    if end < first:
        raise UsageError(f"--to {end:g} is outside {record}")
    if end < begin:
        raise UsageError("the time window is empty: --to is before --from")
    return begin, end


def window_of(options, record, events):
    """The time window to draw [s], [s]."""
    first, last = record.time[[0, -1]]
    if options.event is None:
        begin, end = asked_window(options, first, last)
    elif options.begin is None and options.end is None:
        begin, end = window_of_event(events, options.event)
    else:
        raise UsageError("--event cannot be combined with --from or --to: give one of them")
    begin, end = max(begin, first), min(end, last)
    if np.count_nonzero((record.time >= begin) & (record.time <= end)) < 2:
        between = f"between {begin:g} s and {end:g} s"
        raise UsageError(f"fewer than two samples lie {between}: give a longer time")
    return begin, end
