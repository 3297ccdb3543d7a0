"""Claims 1E and SI: friction of blocks around their rupture, slip of one block; made up."""

import runpy

import numpy as np

from claims.judge import holds
from conftest import ROOT, approx
from curves import Blocks, cases_1E
from events.conventions import PRIMARY

MIDDLE = "the middle block"
# Five blocks, two of them in the loading zone; the third is in the middle of 0.12 m.
FRONT: dict = {
    "x": [0.0, 0.02, 0.06, 0.09, 0.12],
    "t_rupture": [0.0, 1e-3, 2e-3, 3e-3, 4e-3],
    "L": 0.12,
}


def peaks(t_peak, after=0.1):
    levels = {"before": 0.2, "at_peak": 0.3, "after": after}
    return {"t_peak": t_peak} | {name: [level] * 5 for name, level in levels.items()}


def verdicts(of_peaks, front=FRONT):
    return {name: holds("1E", cases) for name, cases in cases_1E(of_peaks, front).items()}


class TestBlockFriction:
    def test_all_blocks_beyond_the_loading_zone_count(self):
        near = [5.0, 5.0, 2e-3, 3.09e-3, 3.91e-3]
        assert verdicts(peaks(near)) == {PRIMARY: True, MIDDLE: True}
        one_off = [*near[:4], 4.2e-3]
        assert verdicts(peaks(one_off)) == {PRIMARY: False, MIDDLE: True}
        case = cases_1E(peaks(one_off), FRONT)[PRIMARY][0]
        assert case["peak minus rupture [ms]"] == approx(0.2)

    def test_a_block_that_does_not_rupture_counts_against_it(self):
        front = FRONT | {"t_rupture": [*FRONT["t_rupture"][:4], None]}
        assert verdicts(peaks(FRONT["t_rupture"]), front) == {PRIMARY: False, MIDDLE: True}

    def test_friction_must_fall_again(self):
        level = peaks(FRONT["t_rupture"], after=0.3)
        assert verdicts(level) == {PRIMARY: False, MIDDLE: False}

    def test_what_comes_later_does_not_count(self):
        blocks = Blocks.__new__(Blocks)
        blocks.time = np.array([0.0, 1.0, 2.0, 3.0])
        blocks.ratio = np.array([[0.1], [0.3], [0.2], [0.9]])
        found = blocks.peaks(2.0)
        assert [found[n][0] for n in ("t_peak", "at_peak", "after")] == [1.0, 0.3, 0.2]


class TestSlowSlip:
    def test_slip_counts_until_two_t_R_or_until_nothing_slips(self):
        reference, unbreakable = (
            {
                "slip_after_two_t_R_over_f_slip_per_k_ij": early,
                "net_slip_over_f_slip_per_k_ij": all_of_it,
            }
            for early, all_of_it in ((7.0, 8.5), (5.0, 5.187))
        )
        script = runpy.run_path(str(ROOT / "recipes/estimate/figure.py"))
        cases = script["cases_SI"](reference, unbreakable)
        held = {until: holds("SI", [case]) for until, case in cases.items()}
        assert held == {"until 2 <t_R>": False, "until nothing slips": True}
