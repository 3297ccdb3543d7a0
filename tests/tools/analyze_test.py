"""analyze and modify-phi: what two commands say of the same files agrees; the numbers are in
tables/."""

import csv
import json
from bisect import bisect_left
from statistics import median

import pytest

from commands import json_of, lines_of, output_of
from conftest import ROOT

pytestmark = pytest.mark.usefixtures("small_ini")


@pytest.fixture
def crossings():
    """q-r.h5, in which blocks fall below three levels one after another."""
    output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5")
    output_of("restart p.h5 -o q.h5 --until 1e-4 --record q-r.h5 --crossings 0.2,0.7")


def test_a_front_goes_by_the_conventions_given(crossings):
    before = 0
    for level in ("0.7", "0.3", "0.2"):
        how = f"q-r.h5 --json --ruptured-below {level}"
        start = json_of(f"analyze events {how}")["events"][0]["t_start"]
        assert start == json_of(f"analyze front {how}")["t_rupture"][2]
        assert start > before
        before = start


@pytest.mark.parametrize("command", ["events", "front"])
def test_several_ways_are_measured_by_one_call(crossings, command):
    for form in (" --json", " --csv", ""):
        measure = f"analyze {command} q-r.h5 --skip-below-x 0.03{form}"
        high = f"{measure} --ruptured-below 0.7"
        expected = output_of(high) + output_of(f"{high} --stencil 3") + output_of(measure)
        assert output_of(f"{high} --also=--stencil=3;--ruptured-below=0.3") == expected


@pytest.mark.parametrize("law", ["reference", "simplified", "decaying", "distance"])
def test_stress_and_ruptures_are_those_that_were_recorded(law):
    output_of(
        "load --config small.ini -o a.h5 --until 4e-4 --checkpoint-at 2e-4 --record r.h5 --set"
        f" junctions.law={law}"
    )
    assert None not in json_of("analyze front r.h5 --json")["t_rupture"]
    loading = json_of("analyze loading r.h5 --x 0.07 --json")
    for file, n in (("a-t0.000200000.h5", 2), ("a.h5", 4)):
        stress = json_of(f"analyze stress {file} --json")
        assert loading["F_T"][n] == stress["F_T"]
        assert loading["p"][n] == stress["p"][4]
        assert loading["tau"][n] == pytest.approx(stress["tau"][4], rel=1e-9)


@pytest.fixture
def seven_events():
    output_of(
        "load --config small.ini -o a.h5 --until 6e-3 --record r.h5 --record-every 1e-4 --set"
        " driving.V=0.1 --set junctions.t_R=2e-5 --set junctions.delta_t_R=0 -q"
    )


def test_events_as_csv_have_what_the_json_has(seven_events):
    how = "--slow-below 3"
    head, *rows = csv.reader(lines_of(output_of(f"analyze events r.h5 --csv {how}")))
    events = json_of(f"analyze events r.h5 --json {how}")["events"]
    assert {bool(event["slow"]) for event in events} == {False, True}
    for row, event in zip(rows, events, strict=True):
        for heading, cell in zip(head, row, strict=True):
            value = event
            for key in heading.split(" ")[0].split("."):
                value = value and value[key]
            found = json.loads(cell) if cell and heading != "type" else cell or None
            assert found == value, heading


def test_the_estimate_follows_the_slip_of_one_block():
    output_of("load --config small.ini -o a.h5 -q")
    estimate = json_of("analyze estimate a.h5 --json")
    time = estimate["relaxation"]["time_over_t_R"]
    slip = estimate["relaxation"]["slip_over_f_slip_per_k_ij"]
    assert len(time) == len(slip) > 100, "each junction is pinned once, and some again"
    assert (time, slip) == (sorted(time), sorted(slip))
    assert slip[0] == 1, "the first pinned junction alone makes up for f_slip"
    net = estimate["net_slip_over_f_slip_per_k_ij"]
    assert slip[-1] == pytest.approx(net, rel=0, abs=1e-12), "equal for all seeds"


@pytest.fixture
def event_I():
    """r.h5: the front starts at 0.015 m, and p changes by up to 3 % until it is slow."""
    start = ROOT / "checkpoints/fast-slow-fast.h5"
    output_of(f"restart {start} -o e.h5 --for 0.006 --record r.h5 --record-every 1e-5 -q")


def test_slow_slip_is_compared_with_the_normal_force_when_it_begins(event_I):
    """Eq. S1 is proportional to p/k_ij, and so to the square root of p."""
    front = json_of("analyze front r.h5 --event 0 --json")
    found = json_of("analyze slow-slip r.h5 --x-from 0 --x-to 0.1 --shortest 0.05 --json")
    blocks, ratios, at_first = found["per_block"], [], []
    assert len(blocks["x"]) > 30
    for x, estimate in zip(blocks["x"], blocks["estimate"]):
        t_rupture = front["t_rupture"][front["x"].index(x)]
        begin = max(t_rupture, found["slow"]["t_from"]) + 0.075 / front["c_s"]
        loading = json_of(f"analyze loading r.h5 --x {x} --json")
        p = loading["p"][bisect_left(loading["time"], begin)]
        ratios.append(estimate**2 / p)
        at_first.append(estimate**2 / loading["p"][0])
    assert max(ratios) / min(ratios) == pytest.approx(1, abs=1e-9)
    assert max(at_first) / min(at_first) > 1.01


def test_the_median_speed_is_that_of_stencils_that_run_forwards(event_I):
    found = json_of("analyze slow-slip r.h5 --x-from 0 --x-to 0.03 --shortest 0.05 --json")
    v_c = [v for v in found["per_block"]["v_c"] if v is not None]
    assert min(v_c) < 0 and found["front_speed"] == median(v for v in v_c if v > 0)
