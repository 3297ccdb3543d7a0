"""Claim 4C: slow points gather at low sigma_bar (recipes/fig4/strength.py); all made up."""

from strength import WAYS, Block, claim_4C, map_strata

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


def judged(maps, events):
    return claim_4C(maps, [POINT], LINES, dict(enumerate(events)))


class TestGathering:
    def test_strata_are_grid_points_of_equal_tau_bar_0(self):
        types = {(0.1, 0.0): "slow", (0.1, 0.1): "fast", (0.2, 0.0): "arrested"}
        assert map_strata(types) == [([0.0], [0.1]), ([], [])]

    def test_each_seed_has_its_own_map(self):
        maps = dict.fromkeys(range(1, 4), GATHERED) | dict.fromkeys((4, 5), MIXED)
        claim = judged(maps, [EVENT] * 8)
        held = {share.convention: share.holds for share in claim.shares}
        assert set(held) == set(WAYS)
        assert (held["primary"], held["permutation test"]) == (1, 1)  # most of them
        claim = judged(maps | {3: MIXED}, [EVENT] * 8)
        assert claim.verdict == "differs" and not any(share.holds for share in claim.shares)

    def test_the_width_of_bins_acts_on_events(self):
        claim = judged(dict.fromkeys(range(1, 6), GATHERED), [EVENT] * 8)
        held = {share.convention: share.holds for share in claim.shares}
        assert [held[f"bins of {width}"] for width in (0.05, 0.2)] == [1, 0]
        assert claim.verdict == "depends"

    def test_without_other_events_it_cannot_be_judged(self):
        assert judged({1: GATHERED}, []).verdict == "not comparable"
