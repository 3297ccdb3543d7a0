"""Claim 4C: slow points gather at low sigma_bar (recipes/fig4/strength.py); all made up."""

from math import isnan

from conftest import approx
from fig4.strength import Block, largest_deviation, map_strata, over_events, prepared_block
from fig4.strength import share_near
from measure.ways import PRIMARY
from measure.pairs import share_of_lower

LINES = {"uniform": ([0.0, 1.0], [1.0, 0.0]), "bell": ([0.0, 1.0], [1.0, 0.5])}
POINT = Block("slow", 0.5, 0.1, 0.5, "uniform")  # on its curve
GATHERED = {(tau, s / 10): "slow" if s < 5 else "fast" for tau in (0.1, 0.2) for s in range(10)}
MIXED = {(tau, s / 10): "slow" if s % 2 else "fast" for tau in (0.1, 0.2) for s in range(10)}


def block(kind, sigma_bar, tau_bar_0):
    return Block(kind, sigma_bar, tau_bar_0, 1 - sigma_bar)


# Lower sigma_bar in all pairs with tau_bar_0 in the same bin of 0.1 or of 0.05, in 7 of the 15
# in the same bin of 0.2.
EVENT = [
    *(block("slow", 0.1, 0.02), block("fast", 0.2, 0.03)),
    *(block("slow", 0.5, 0.12), block("slow", 0.5, 0.12), block("fast", 0.6, 0.13)),
    *(block("fast", 0.3, 0.04), block("fast", 0.3, 0.04), block("fast", 0.3, 0.04)),
]


class TestGathering:
    def test_strata_are_grid_points_of_equal_tau_bar_0(self):
        types = {(0.1, 0.0): "slow", (0.1, 0.1): "fast", (0.2, 0.0): "arrested"}
        assert map_strata(types) == [([0.0], [0.1]), ([], [])]

    def test_slow_points_of_a_map_gather_or_do_not(self):
        shares = [share_of_lower(map_strata(types)) for types in (GATHERED, MIXED)]
        assert shares == [1.0, approx(0.4)]

    def test_the_width_of_bins_acts_on_events(self):
        found = over_events([EVENT, EVENT, []])
        shares = {way: share for way, (_, share) in found.items()}
        assert shares == {PRIMARY: 1.0, "bins of 0.05": 1.0, "bins of 0.2": approx(7 / 15)}
        assert [count for count, _ in found.values()] == [2] * 3
        assert isnan(over_events([])[PRIMARY][1])

    def test_a_prepared_point_is_a_block_beyond_the_trigger_region(self):
        of_block = {name: [0.0] * 9 + [0.3] * 48 for name in ("sigma_bar", "mu_bar_eff")}
        found = prepared_block(of_block, {"type": "none"}, 0.1, "bell")
        assert found == Block("arrested", 0.3, 0.1, 0.3, "bell")

    def test_the_largest_deviation_from_a_curve_may_be_below_it(self):
        low = Block("slow", 0.5, 0.1, 0.45, "uniform")
        assert largest_deviation([POINT, low], LINES) == approx(0.1)

    def test_a_block_is_near_if_one_of_the_curves_is(self):
        # at sigma_bar = 0.5 the curves are at 0.5 and 0.75
        at = {mu: share_near([POINT._replace(mu_bar_eff=mu)], LINES) for mu in (0.39, 0.41, 0.84)}
        assert at == {0.39: 0.0, 0.41: 1.0, 0.84: 1.0}
        nothing = POINT._replace(mu_bar_eff=float("nan"))  # without contact
        assert share_near([POINT, POINT._replace(mu_bar_eff=0.86), nothing], LINES) == 0.5
