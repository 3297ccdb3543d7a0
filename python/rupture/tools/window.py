# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The record that a program draws, and the time of it."""

import numpy as np

from rupture.errors import Failure
from rupture.files import Record, open_file
from rupture.tools.command_line import UsageError

MARGIN = 0.15  # shown before and after an event, of its duration
LEAST_MARGIN = 0.5e-3  # [s]


def add_window(parser):
    text = "draw this event of `analyze events`"
    parser.add_argument("--event", type=int, metavar="N", help=text)
    parser.add_time("--from", "draw from this time on", dest="begin")
    parser.add_time("--to", "draw up to this time", dest="end")


def open_record(path):
    record = open_file(path)
    if not isinstance(record, Record):
        raise Failure(f"{path} is a checkpoint; give a record")
    if len(record.time) < 2:
        raise Failure(f"{path} has fewer than two samples; wait until its run has written more")
    return record


def window_of_event(events, number):
    """[s], [s]"""
    if not 0 <= number < len(events):
        has = f"events 0 to {len(events) - 1}" if events else "no events"
        raise UsageError(f"there is no event {number}: the record has {has}")
    start, end = events[number]["t_start"], events[number]["t_end"]
    margin = max(MARGIN * (end - start), LEAST_MARGIN)
    return start - margin, end + margin


def window_of(options, record, events):
    """The time to be drawn [s], [s]."""
    if options.event is not None:
        begin, end = window_of_event(events, options.event)
    else:
        begin = record.time[0] if options.begin is None else options.begin
        end = record.time[-1] if options.end is None else options.end
    begin, end = max(begin, record.time[0]), min(end, record.time[-1])
    if np.count_nonzero((record.time >= begin) & (record.time <= end)) < 2:
        raise UsageError(f"fewer than two samples lie between {begin:g} s and {end:g} s")
    return begin, end


def events_in(events, begin, end):
    return [event for event in events if event["t_end"] >= begin and event["t_start"] <= end]
