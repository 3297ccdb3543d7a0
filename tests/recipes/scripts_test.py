"""Scripts of chains that measure, each on a case worked by hand."""

import numpy as np
from pytest import fixture

import deviation
import distance
import exponential_order
import junction
import junctions
import prestress
import slow_slip
import strength
import symmetry
from claims.cases import Names
from claims.judge import table
from chains.script import module_at
from conftest import ROOT, approx
from made_up import Made
from measure.conventions import PRIMARY


@fixture(name="given")
def points_of_a_file(monkeypatch):
    """given(SCRIPT, POINTS): these are what the script reads."""

    def given(script, *points):
        monkeypatch.setattr(script, "read_points", lambda _: list(points))

    return given


def stress(p, tau, F_T=0.0):
    x = [0.0, 0.07, 0.14]
    return {"x": x, "p": p, "tau": tau, "F_T": F_T, "F_N": sum(p), "time": 0.0}


def test_S1_symmetry_and_the_shift_of_the_centroid(given, monkeypatch):
    unloaded = stress([1.0, 2.0, 1.04], [-2.0, 0.1, 1.9])
    before = stress([1.0, 2.0, 1.0 + 0.2], [0.0] * 3, F_T=4.2)
    given(symmetry, Made(unloaded=unloaded, before=before))
    monkeypatch.setattr(symmetry.rupture, "open", lambda _: {"driving.h": 0.002})
    found = symmetry.main("base.h5", "points")
    # centroids: 0.07 * 0.04 / 4.04 and 0.07 * 0.2 / 4.2; the lever is 4.2 * 0.002 / 4.2
    shift = 0.07 * (0.2 / 4.2 - 0.04 / 4.04)
    assert (found["of_p"], found["of_tau"]) == approx((0.04 * 3 / 4.04, 0.1))
    assert (found["sum_of_p"], found["shift"]) == approx((0, shift), abs=1e-12)
    assert found["over_lever"] == approx(shift / 0.002)


def test_S3_the_largest_deviation_of_all_interfaces_and_what_depinning_takes(given):
    x, p = [0.02, 0.0225], [2.0, 2.0]  # inside the trigger region, and outside
    exact = [0.239 * 2, (0.17 + 0.23 * 0.2) * 2]  # tau-bar 0.3 in the trigger region

    def point(later, depinned):
        """States that are so much lower than they should be."""
        of = {"x": x, "p": p, "F_N": 4.0}
        states = {"before": exact, "later": [exact[0], exact[1] * (1 - later)]}
        states["depinned"] = [tau * (1 - depinned) for tau in (0.17 * 2, exact[1])]
        return Made({"tau-bar": 0.2} | {name: of | {"tau": tau} for name, tau in states.items()})

    given(prestress, point(0.01, 0.0), point(0.0, 0.05))
    found = prestress.main("points")
    expected = {"before": 0, "later": 0.01, "depinned": 0.05, "p": 0, "interfaces": 2}
    expected |= {"force_drop": 0.138, "force_drops_differ": 0.017 / 0.138}  # 0.3 (mu_s - mu_d) p
    assert found == approx(expected, abs=1e-12)


def test_S4_the_least_uniform_of_the_changed_blocks(given, monkeypatch):
    class MadeUp(junctions.Junctions):
        def __init__(self, *_):
            self.f_thres, self.x_over_L = np.full(3, 2.0), np.array([0.0, 0.25, 1.0])
            quantiles = np.array([-0.75, -0.25, 0.25, 0.75])  # f_thres - |mean| = 1
            self.force = np.stack([np.ones(4), 1 + quantiles, 1 + quantiles - [0, 0, 0, 0.4]])
            self.force[2] += 0.1
            self.slipping = np.zeros((3, 4), bool)

    monkeypatch.setattr(junctions, "Junctions", MadeUp)
    point = Made(phi_wider={})
    monkeypatch.setattr(Made, "file", lambda *_: "start.h5", raising=False)
    given(junctions, point)
    found = junctions.main("points")
    p, distances = zip(*(junctions.beside_widest_uniform(MadeUp(), n) for n in (1, 2)))
    assert (found["blocks"], found["p"]) == (2, approx(min(p)))
    assert p[1] != approx(p[0])
    assert (distances[0], found["distance"]) == approx((0, 0.15), abs=1e-9)


def test_S5_both_shapes_must_fall(given):
    def point(shape, sigma_bar, mu_bar):
        values = {"shape": shape, "sigma-bar": sigma_bar}
        return Made(values | {"strength": {"mu_bar_eff": mu_bar, "mu_eff": 0.0}})

    closed = [deviation.uniform_closed_form(sigma) for sigma in (0.0, 0.1)]
    bell = [point("bell", 0.0, 1.0), point("bell", 0.1, 0.8)]
    given(deviation, *(point("uniform", 0.1 * n, mu) for n, mu in enumerate(closed)), *bell)
    found = deviation.main("points")
    assert found["falls"] and found["uniform_closed"] == 0
    assert found["bell_quadrature"] == approx(abs(0.8 - deviation.largest_mean_force("bell", 0.1)))
    given(deviation, point("uniform", 0.0, 1.0), point("uniform", 0.1, 1.01), *bell)
    found = deviation.main("points")
    assert not found["falls"] and found["uniform_closed"] == approx(1.01 - closed[1])


def test_1F_forces_of_a_junction_beside_the_law():
    pulled = junction.Pulled.__new__(junction.Pulled)
    pulled.time = np.arange(6.0)
    pulled.u = np.array([[1.0, 2, 4, 4.5, 5, 6]]).T
    pulled.attachment, pulled.k, pulled.mu_s, pulled.mu_d = np.zeros(1), 1.0, 0.4, 0.17
    pulled.f_N = np.full((6, 1), 9.0)
    pulled.f_thres, pulled.f_slip = 3.6, 1.53
    pulled.pinned = np.array([[1, 1, 0, 0, 1, 1]], bool).T
    pulled.f = np.array([[1.0, 2.0, 1.53, 1.53, 0.0, 1.36]]).T  # 1 was to be expected in the end
    change = np.diff(pulled.pinned.astype(int), axis=0, prepend=pulled.pinned[:1])
    pulled.breaks, pulled.repins = change < 0, change > 0
    pulled.repin_times = np.array([[2.5]])
    found = junction.law_of(pulled)
    assert found["deviation"] == approx(0.1)
    counts = {"junctions": 1, "breaks": 1, "repinnings": 1, "latest_repinning": 1}
    assert found.items() >= (counts | {"moves_forwards": True}).items()
    assert found["breaks_beyond_f_thres"]  # 4 > 3.6, and 2 before
    pulled.u[2] = 3.5
    assert not junction.law_of(pulled)["breaks_beyond_f_thres"]


def test_exponential_map_counts_types_and_what_is_out_of_order(given, monkeypatch):
    fronts = {(0.1, 0.0): "slow", (0.2, 0.0): "arrested", (0.3, 0.0): "fast", (0.4, 0.0): "fast"}
    maps = {place: {1: {"types": {PRIMARY: kind}}} for place, kind in fronts.items()}
    given(exponential_order)
    monkeypatch.setattr(exponential_order, "rows_of", lambda _: [])
    monkeypatch.setattr(exponential_order, "read_map", lambda _: maps)
    found = exponential_order.main("points")
    assert found == {"arrested": 1, "slow": 1, "fast": 2, "out_of_order": 1}


def test_a_front_that_does_not_arrest_reaches_the_end_under_the_distance_law():
    event = {"type": "slow", "slow": {"x_from": 0.07}, "L": 0.14}
    for x_arrest, reaches in ((None, 1), (0.07, 0.5)):
        kind = "slow" if x_arrest is None else "arrested"
        found = distance.measured_event(event, event | {"x_arrest": x_arrest, "type": kind})
        assert found["which reaches [L]"] == reaches


def test_4C_kinds_of_blocks():
    assert strength.kind_of(0.019, 1.0, 1000) == "loading zone"
    kinds = [strength.kind_of(0.02, v, 1000.0) for v in (49.9, 50.0, -1.0, np.nan)]
    assert kinds == ["slow", "fast", None, None]


def test_3C_neighbours_are_alike_up_to_a_fifth(monkeypatch):
    rows = [{"variant": "k_i", "ratio": None}, {"variant": "reference", "ratio": 1.3}]
    rows += [{"variant": "t_R", "ratio": 1.2}]
    monkeypatch.setattr(slow_slip.slow, "fronts", lambda _: rows)
    monkeypatch.setattr(slow_slip, "largest_ratio", lambda row: row["ratio"])
    found = slow_slip.neighbours([])
    assert found == {"largest": 1.3, "of_all": [None, 1.3, 1.2]}
    case = Names(table()["3C-neighbours"], Made(neighbours=found)).case()
    assert [*case.values()] == [1.3, 3, 1]


def test_choices_compare_medians_by_drawing_runs_again():
    """Of runs with the values 1, 2 and 3: both are the first in a quarter of the draws, with the
    median 1.5, both are the second in another."""
    choices = module_at(ROOT / "recipes/choices/figure.py")
    kept = {"fast_slow_fast": True, "type": "slow", "c_s": 1.0, "L": 1.0}
    events = [kept | {"slow": {"slowest": v}} for v in (1.0, 2.0, 3.0)]
    fast = kept | {"fast_slow_fast": False, "type": "fast", "speed": 7.0, "slow": None}
    found = choices.of_spanning([events[:2], [events[2], fast], []])
    slowest, share = found["slowest/c_s"], found[choices.SHARE]
    assert (slowest.value, slowest.low, slowest.high, slowest.n) == (2.0, 1.5, 3.0, 3)
    assert (share.value, share.n) == (0.75, 4)
    alone = found[choices.FAST_ONLY]
    assert (alone.value, alone.low) == (7.0, None)
    assert slowest.beside(choices.Found(1.2, 1.0, 1.4)).moved == "up"
    assert slowest.beside(choices.Found(1.2, 1.0, 1.5)).moved == ""
    assert slowest.beside(choices.Found(4.0, 3.1, 5.0)).moved == "down"
