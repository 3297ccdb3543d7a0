"""What rows of claims.toml measure beside their conditions, and the friction of single blocks; all
made up."""

import numpy as np
from pytest import mark

from claims.cases import Names
from claims.judge import table
from conftest import approx
from examples import WORDS
from made_up import Made
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


def test_3C_ratios_take_the_peak_of_every_step():
    reports = {
        "fast_slip": {"time": [0.0, 1.0, 1.5, 2.5], "slip": [0.0, 0.1, 0.3, 0.35]},
        "slip_stopped": {"slow_speed": 0.2, "fast_slip": 6e-6, "slow_slip": 3e-6},
    }
    case = Names(table()["3C-ratios"], Made(reports)).case()
    assert [*case.values()] == approx([2, 2, 400])


def test_5A_says_where_the_front_was_when_the_driving_stopped():
    front = {"t_rupture": [0.0, 1e-3, None, 3e-3], "x": [0.01, 0.02, 0.03, 0.04], "L": 0.1}
    text = table()["5A"]["measured"]["driving stopped at [L]"]
    assert value("5A", text, front=front, amid=1e-3) == approx(0.2)


def test_peaks_count_until_shortly_after_the_first_rupture_of_the_last_block():
    class Record(dict):  # the second block has no contact; the first one ruptures once more
        time = AFTER * np.arange(4)
        ruptures = Ruptures(AFTER * np.array([0.5, 1, 3]), None, np.array([1, 0, 0]), None)

    tau = np.array([[0.1, 0.3, 0.2, 0.9], [0.0] * 4]).T
    found = peaks_of(Record(tau=tau, p=np.array([[1.0, 0.0]] * 4)))
    assert found["t_peak"][0] == AFTER
    levels = [[x, None] for x in (0.1, 0.3, 0.2)]
    assert [found[n] for n in ("before", "at_peak", "after")] == levels
