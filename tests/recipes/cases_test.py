"""What rows of claims.toml measure beside their conditions, and the friction of single blocks; all
made up."""

import re

import numpy as np
from pytest import mark

from chains.chain import Chain
from chains.expressions import Expression
from claims.cases import Names
from claims.judge import table
from conftest import ROOT, approx
from examples import WORDS
from made_up import Made
from measure.fronts import middle_of
from measure.slip import AFTER, peaks_of
from rupture.files import Ruptures


def value(claim_id, text, **reports):
    return Names(table()[claim_id], Made(reports)).value(text)


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
    for claim_id in ("2A", "S6A", "exponential-event"):
        assert value(claim_id, "in_time", event=WORDS | {"t_rupture": t_rupture}) == expected


def test_3C_ratios_take_the_peak_of_every_step_until_the_arrest_and_that_of_the_slide():
    stopped: dict = {"slow_speed": 0.2, "fast_slip": 6e-6, "slow_slip": 3e-6}
    stopped |= {"t_arrest": 1.4, "slow_end": 4.0}
    stopped |= {"time": [0.0, 3.0, 4.0, 5.0, 6.0], "slip": [0.0, 9.0, 9.1, 9.8, 10.4]}
    reports = {
        "fast_slip": {"time": [0.0, 1.0, 1.5, 2.5], "slip": [0.0, 0.1, 0.3, 5.0]},
        "slip_stopped": stopped,
    }
    case = Names(table()["3C-ratios"], Made(reports)).case()
    assert [*case.values()] == approx([2, 2, 400, 700])


LINE = {"t_rupture": [0.0, 1e-3, None, 3e-3], "x": [0.01, 0.02, 0.03, 0.04], "L": 0.1}
SPANS = {"events": [{"t_start": t, "spanning": t > 1, "is_over": t < 3} for t in (1.0, 2.0, 3.0)]}


@mark.parametrize(
    "claim_id, quantity, reports, expected",
    [
        ("5A", "driving stopped at [L]", {"front": LINE, "amid": 1e-3}, 0.2),
        ("1D", "first spanning event at [s]", {"measured": SPANS}, 2),
    ],
)
def test_what_is_measured_beside_conditions(claim_id, quantity, reports, expected):
    text = table()[claim_id]["measured"][quantity]
    assert value(claim_id, text, **reports) == approx(expected)


@mark.parametrize(
    "chain, stretch", [("ensemble/continued", "event.in_words"), ("fig5/undriven", "front.slow")]
)
def test_the_driving_stops_in_the_middle_of_the_slow_stretch(chain, stretch):
    text = Chain(ROOT / f"recipes/{chain}.ini").sections["values"]["amid"]
    name, key = stretch.split(".")
    times = {"t_from": 1.0, "t_to": 2.0}
    found = Expression(text[1:-1], [name]).value({name: {key: times}}.__getitem__)
    assert found == middle_of(times)


def test_events_branch_where_the_convention_says():
    for row in table().values():
        for name, of in ({"branch at 0.14 L": row} | row.get("under", {})).items():
            if found := re.search(r"branches where block == (\d+)", of.get("each", "")):
                assert name == f"branch at {int(found[1]) / 56:.2g} L", row["id"]


def test_peaks_count_until_shortly_after_the_first_rupture_of_the_last_block():
    class Record(dict):  # the second block has no contact; the first one ruptures once more
        time = AFTER * np.arange(4)
        ruptures = Ruptures(AFTER * np.array([0.5, 1, 3]), None, np.array([1, 0, 0]), None)

    tau = np.array([[0.1, 0.3, 0.2, 0.9], [0.0] * 4]).T
    found = peaks_of(Record(tau=tau, p=np.array([[1.0, 0.0]] * 4)))
    assert found["t_peak"][0] == AFTER
    levels = [[x, None] for x in (0.1, 0.3, 0.2)]
    assert [found[n] for n in ("before", "at_peak", "after")] == levels
