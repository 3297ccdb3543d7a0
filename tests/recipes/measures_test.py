"""What recipes measure in Python, each on a case worked by hand."""

import numpy as np
import rupture
from pytest import mark, raises
from rupture.errors import Failure

from choices import figure as choices
from claims_test import copied
from conftest import approx
from events import checked
from fig1 import junction
from fig4 import strength
from figS1.commands import symmetry
from figS3.commands import front, prestress, trigger
from figS4 import junctions
from figS5.commands import deviation
from figS5.quadrature import largest_mean_force, uniform_closed_form
from measure.ways import PRIMARY
from measure.drawn import nothing_drawn
from robustness import distance


def stress(p, tau, F_T=0.0):
    x = [0.0, 0.07, 0.14]
    return {"x": x, "p": p, "tau": tau, "F_T": F_T, "F_N": sum(p), "time": 0.0}


def test_S1_symmetry_and_the_shift_of_the_centroid():
    unloaded = stress([1.0, 2.0, 1.04], [-2.0, 0.1, 1.9])
    before = stress([1.0, 2.0, 1.0 + 0.2], [0.0] * 3, F_T=4.2)
    found = symmetry(copied({"unloaded": unloaded, "before": before, "h": 0.002}), PRIMARY)
    of_p, of_tau, sum_of_p, difference, shift = found.values()
    # centroids: 0.07 * 0.04 / 4.04 and 0.07 * 0.2 / 4.2; the lever is 4.2 * 0.002 / 4.2
    expected = 0.07 * (0.2 / 4.2 - 0.04 / 4.04)
    assert (of_p, of_tau) == approx((0.04 * 3 / 4.04, 0.1))
    assert (sum_of_p, shift) == approx((0, 1e3 * expected), abs=1e-9)
    assert difference == approx(100 * (expected / 0.002 - 1))


def interface(later, depinned):
    """One whose states have so much less stress than they should have."""
    x, p = [0.02, 0.0225], [2.0, 2.0]  # inside the trigger region, and outside
    exact = [0.239 * 2, (0.17 + 0.23 * 0.2) * 2]  # tau-bar 0.3 in the trigger region
    of = {"x": x, "p": p, "F_N": 4.0}
    states = {"before": exact, "later": [exact[0], exact[1] * (1 - later)]}
    states["depinned"] = [tau * (1 - depinned) for tau in (0.17 * 2, exact[1])]
    return copied({"tau_bar": 0.2} | {name: of | {"tau": tau} for name, tau in states.items()})


def test_S3_the_largest_deviation_of_all_interfaces_and_what_depinning_takes():
    of = [interface(0.01, 0.0), interface(0.0, 0.05)]
    assert [*prestress(of, PRIMARY).values()] == approx([2, 0.05, 0, 0.01, 0.05, 0])
    # 0.3 (mu_s - mu_d) p
    assert [*trigger(of, PRIMARY).values()] == approx([0.138, 0.017 / 0.138])


def test_S3_speeds_are_medians_beyond_the_trigger_region():
    of = {"x": [0.02, 0.03, 0.04, 0.05], "v_c": [9.0, 5.0, None, 7.0], "type": "none"}
    found = front(copied({"front": of | {"criteria": {"skip_below_x": 0.0275}}}), PRIMARY)
    assert [*found.values()] == ["arrested", 6]


def test_S4_the_least_uniform_of_the_changed_blocks(monkeypatch):
    class MadeUp(junctions.Junctions):
        def __init__(self, *_):
            self.f_thres, self.x_over_L = np.full(3, 2.0), np.array([0.0, 0.25, 1.0])
            quantiles = np.array([-0.75, -0.25, 0.25, 0.75])  # f_thres - |mean| = 1
            self.force = np.stack([np.ones(4), 1 + quantiles, 1 + quantiles - [0, 0, 0, 0.4]])
            self.force[2] += 0.1
            self.slipping = np.zeros((3, 4), bool)

    monkeypatch.setattr(junctions, "Junctions", MadeUp)
    monkeypatch.setattr(rupture, "analyze", lambda *_: {})
    found = junctions.beside_uniform("start.h5")
    p, distances = zip(*(junctions.beside_widest_uniform(MadeUp(), n) for n in (1, 2)))
    assert (found["blocks"], found["p"]) == (2, approx(min(p)))
    assert p[1] != approx(p[0])
    assert (distances[0], found["distance"]) == approx((0, 0.15), abs=1e-9)


def test_S5_quadrature_is_another_way():
    of_bell = [largest_mean_force("bell", sigma) for sigma in (0.1, 0.2)]
    for sigma, expected in ((0.1, 1 - 3**0.5 / 10), (0.4, 1 / (1.6 * 3**0.5))):
        assert uniform_closed_form(sigma) == approx(expected)
        assert largest_mean_force("uniform", sigma) == approx(expected)
    uniform = [uniform_closed_form(sigma) for sigma in (0.1, 0.2)]
    of = [{"mu_bar": uniform, "quadrature": uniform}, {"mu_bar": [0.9, 0.8], "quadrature": of_bell}]
    found = deviation(copied([one | {"sigma_bar": [0.1, 0.2]} for one in of]), PRIMARY)
    largest = max(abs(0.9 - of_bell[0]), abs(0.8 - of_bell[1]))
    assert [*found.values()] == approx([1, largest, 0, 0, largest])


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


@mark.parametrize("draws", [[0, 0], [0, 1]])
def test_a_state_in_which_slipping_times_are_drawn_belongs_to_one_seed(draws, monkeypatch):
    state = {"junctions/draws": np.array(draws)}
    monkeypatch.setattr(rupture, "open", lambda _: state)
    if any(draws):
        with raises(Failure, match="differ in their seeds differ here"):
            nothing_drawn("start.h5")
    else:
        nothing_drawn("start.h5")


def test_a_shipped_checkpoint_must_be_the_one_in_the_manifest(folder, monkeypatch):
    monkeypatch.setattr("events.output_of", lambda *_: "5eed\n")
    for name, fits in (("fast-only", True), ("second-slow", False)):
        (folder / "manifest").write_text(f"content-sha256 5eed  {name}.h5\n")
        if fits:
            checked(folder / "fast-only.h5", folder / "manifest")
        else:
            with raises(Failure, match="fast-only.h5 is not in its manifest"):
                checked(folder / "fast-only.h5", folder / "manifest")


def test_choices_compare_medians_by_drawing_runs_again():
    """Of runs with the values 1, 2 and 3: both are the first in a quarter of the draws, with the
    median 1.5, both are the second in another."""
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
