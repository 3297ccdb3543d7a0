"""How the recipe `speeds` measures, on made-up slip and fronts with known answers."""

from types import SimpleNamespace

import numpy as np
import rupture
from pytest import mark
from rupture.files import Ruptures

from claims.own_result import compared, text_of
from conftest import approx
from measure.tables import numbers
from speeds.front_slip import exponent, slip_speed, transient
from speeds.slip_history import gini, history_of, slip_in_bins


@mark.parametrize(
    "parts, coefficient",
    [([3, 3, 3, 3], 0), ([0, 0, 5, 0], 1 - 1 / 4), ([1, 3], 0.25), ([0, 0], None)],
)
def test_gini(parts, coefficient):
    assert gini(parts) == approx(coefficient)


def test_slip_is_binned_from_the_rupture_on():
    time = np.linspace(0, 0.03, 301)
    slip = slip_in_bins(time, np.clip(time, 0.0125, 0.0155), 0.0115)  # moves after 1 ms, for 3 ms
    assert slip == approx([0, *[1e-3] * 3, *[0] * 6], abs=1e-12)
    assert not slip_in_bins(time, -time, 0.0115).any()


def test_a_block_is_measured_at_the_first_checkpoint_10_ms_after_its_rupture(monkeypatch):
    class Record(dict):
        time, x = np.array([0.0, 0.3]), [0.07]
        ruptures = Ruptures(np.array([0.1, 0.2]), None, np.array([0, 0]), None)

    def opened(path):
        slips = Record(u_x=np.array([[0.0], [0.3]]))
        return slips if path == "record.h5" else SimpleNamespace(time=float(path))

    monkeypatch.setattr(rupture, "open", opened)
    monkeypatch.setattr(rupture, "analyze", lambda _, path: {"mu_bar_eff": [float(path)]})
    [row] = history_of("record.h5", "0.105", "0.115", "0.125", "0.205")
    assert (row["mu_bar_eff"], row["slip after 2 ms [m]"]) == approx((0.115, 0.008))


@mark.parametrize("us, speed", [(10, 0.25), (10.5, 1 / 3.5), (13, 0.5), (28, np.nan)])
def test_slip_speed_is_over_one_micrometre_from_the_rupture_on(us, speed):
    time = np.arange(30) * 1e-6
    moved = 0.5 * np.clip(time - 12e-6, 0, None)
    found = slip_speed({"time": time, "slip": moved, "t_rupture": us * 1e-6})
    assert found == approx(speed, nan_ok=True)


@mark.parametrize("before, length", [(100, 35), (170, 0), (250, 35)])
def test_a_transient_ends_where_the_speed_stays_near_the_final_one(before, length):
    x = np.arange(57) * 0.0025
    v_c = np.where(x < 0.06, before, 200).tolist()
    front = {"x": x, "v_c": [None, None, *v_c[2:-2], None, None], "L": 0.14}
    front["criteria"] = {"skip_below_x": 0.0275}
    assert transient(front) == approx(length)


def test_a_zero_is_a_number():
    found = numbers([{"slip": cell} for cell in (0.0, "0", "", None)], "slip")
    assert found == approx([0, 0, np.nan, np.nan], nan_ok=True)


def test_exponent():
    rows = [{"M": str(M), "v": M**-0.5} for M in (0.5, 1.0, 2.0)]
    assert exponent(rows, "v", "M") == approx(-0.5)


@mark.parametrize("found, outcome", [(0.6, "as expected"), (0.4, "not as expected")])
def test_an_own_result_may_have_an_expectation(found, outcome):
    result = compared("a", {"r": found, "n": 7}, "so?", {"r": {"at_least": 0.5}})
    text = f"a (ours, {outcome}): so?\n  r (expected: at least 0.5) = {found}\n  n = 7"
    assert text_of(result) == text
