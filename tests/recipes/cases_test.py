"""What rows of claims.toml measure beside their conditions, where events branch, and the friction
of single blocks; all made up."""

from types import SimpleNamespace

import numpy as np
from pytest import mark
from rupture.files import Ruptures
from rupture.once import Report

import events
import fig1.commands
import fig3.commands
import fig5.commands
from claims_test import copied
from conftest import approx
from examples import WORDS
from fig2.commands import fast_slow_fast, shown_of
from measure.ways import PRIMARY
from measure.slip import AFTER, peaks_of

IN_TIME = "fast, slow and fast in order of time"


@mark.parametrize(
    "t_rupture, expected",
    [
        ([0.0, 0.1, 0.2, 1.0, 2.0, 2.1, 2.2], True),
        ([0.0, 2.1, 2.0, 1.0, 1.9, 2.1, 2.2], False),  # what is before the stretch comes after
        ([0.0, 0.1, 0.2, 1.0, 2.0, 0.4, 0.3], False),  # what is behind it comes before
        ([0.0, None, 0.2, 1.0, 2.0, 2.1, None], True),
    ],
)
def test_an_event_is_fast_slow_fast_in_order_of_time(t_rupture, expected):
    [case] = fast_slow_fast({PRIMARY: [copied(WORDS | {"t_rupture": t_rupture})]}, PRIMARY)
    assert case[IN_TIME] == expected


@mark.parametrize(
    "kinds, shown", [("--", 0), ("-s", 1), ("sfs", 0), ("-fs", 2)]  # f: one that does not span
)
def test_of_a_run_the_first_event_that_is_fast_slow_fast_is_shown(kinds, shown, monkeypatch):
    of_run = [Report(spanning=k != "f", fast_slow_fast=k == "s", n=n) for n, k in enumerate(kinds)]
    monkeypatch.setattr("fig2.commands.shown_events", lambda _: {PRIMARY: of_run})
    assert [event.n for event in shown_of("law")[PRIMARY]] == [shown]


def test_3C_ratios_take_the_peak_of_every_step_until_the_arrest_and_that_of_the_slide():
    stopped: dict = {"slow_speed": 0.2, "fast_slip": 6e-6, "slow_slip": 3e-6}
    stopped |= {"t_arrest": 1.4, "slow_end": 4.0}
    stopped |= {"time": [0.0, 3.0, 4.0, 5.0, 6.0], "slip": [0.0, 9.0, 9.1, 9.8, 10.4]}
    every_step = {"time": [0.0, 1.0, 1.5, 2.5], "slip": [0.0, 0.1, 0.3, 5.0]}
    found = fig3.commands.ratios(copied({"every_step": every_step, "slip": stopped}), PRIMARY)
    assert [*found.values()] == approx([2, 2, 400, 700])


@mark.parametrize("measured", [fig3.commands.slip, fig3.commands.beginning])
def test_a_block_that_had_ruptured_before_the_branch_is_no_sample(measured):
    """Its fast slip came before anything was changed. One that never ruptures counts against."""
    known: dict = {name: None for name in ("t_rupture", "t_arrest", "fast_slip", "slow_slip")}
    known |= {"slow_rms": None, "slow_r_squared": None, "time": [0.0], "slip": [0.0]}
    assert measured(copied([known | {"t_before": 0.63}] * 3), PRIMARY) is None
    assert measured(copied([known | {"t_before": None}] * 3), PRIMARY) is not None


LINE = {"t_rupture": [0.0, 1e-3, None, 3e-3], "x": [0.01, 0.02, 0.03, 0.04], "L": 0.1}
STOPPED: dict = {"fronts": {PRIMARY: LINE | {"in_words": None}}, "stop": 1e-3}
STOPPED["undriven"] = {PRIMARY: LINE | {"type": "slow"}}
EVENT = {"F_T_before": 2.0, "F_T_after": 1.0, "t_rupture": [0.0]}
TIMES = (0.5, 1.0, 2.0, 3.0)  # the first of these is not over
RUN = {PRIMARY: [EVENT | {"t_start": t, "spanning": t != 1, "is_over": t > 0.5} for t in TIMES]}


@mark.parametrize(
    "measured, quantity, sample, expected",
    [
        (fig5.commands.difference, "driving stopped at [L]", STOPPED, 0.2),
        (fig1.commands.drops, "first spanning event at [s]", RUN, 2),
    ],
)
def test_what_is_measured_beside_conditions(measured, quantity, sample, expected):
    assert measured(copied(sample), PRIMARY)[quantity] == approx(expected)


def test_events_branch_where_the_convention_says():
    for block, name in events.BLOCKS.items():
        assert name in (PRIMARY, f"branch at {block / 56:.2g} L")
    assert events.BLOCKS[8] == PRIMARY


def test_an_event_starts_half_a_millisecond_before_from_the_last_checkpoint(monkeypatch):
    lines = []

    def run(line, keep):
        lines.append(line)
        return {"start.h5": ""}

    monkeypatch.setattr("events.run", run)
    load = {events.checkpoint_at(time): f"t={time:g}" for time in events.TIMES}
    for t_start in (0.4203, 0.4006, 0.4005):
        events.before(load, SimpleNamespace(t_start=t_start))
    starts = [line.split()[1::4] for line in lines]
    assert starts == [["t=0.4", "0.4198"], ["t=0.4", "0.4001"], ["t=0.35", "0.4"]]


def test_an_event_lasts_twice_as_long_as_it_took_at_least_10_ms():
    for last, lasting in ((1.003, 0.01), (1.006, 0.012)):
        event = SimpleNamespace(t_start=1.0, t_rupture=[1.0, None, last])
        assert events.duration(event) == approx(lasting)


def test_peaks_count_until_shortly_after_the_first_rupture_of_the_last_block():
    class Record(dict):  # the second block has no contact; the first one ruptures once more
        time = AFTER * np.arange(4)
        ruptures = Ruptures(AFTER * np.array([0.5, 1, 3]), None, np.array([1, 0, 0]), None)

    tau = np.array([[0.1, 0.3, 0.2, 0.9], [0.0] * 4]).T
    found = peaks_of(Record(tau=tau, p=np.array([[1.0, 0.0]] * 4)))
    assert found["t_peak"][0] == AFTER
    levels = [[x, None] for x in (0.1, 0.3, 0.2)]
    assert [found[n] for n in ("before", "at_peak", "after")] == levels
