"""Maps of front types (recipes/maps/front_map.py, map_claims.py) and rank tests (rank_test.py)."""

import sys
import unittest
from pathlib import Path

import numpy as np
from scipy.stats import mannwhitneyu

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "recipes"))

from data.rank_test import share_of_lower, van_elteren  # noqa: E402
from maps.front_map import (  # noqa: E402
    boundary,
    changes,
    fast_below_left_of_arrested,
    front_type,
    middle,
    neighbours,
    to_refine,
)
from claims.judge import holds  # noqa: E402
from maps.map_claims import measured  # noqa: E402

C_S = 1000.0  # [m/s]


def front(v_c, arrives=True):
    """A front over six blocks of which the first two are in the trigger region."""
    return {
        "x": [0.0, 0.01, 0.03, 0.04, 0.05, 0.06],
        "t_rupture": [0.0, 0.0, 0.1, 0.2, 0.3, 0.4 if arrives else None],
        "v_c": v_c,
        "c_s": C_S,
    }


class Types(unittest.TestCase):
    def test_a_stencil_below_the_threshold_makes_a_front_slow(self):
        speeds = [None, None, 300.0, 60.0, None, None]
        self.assertEqual(front_type(front(speeds)), "fast")
        self.assertEqual(front_type(front(speeds), 1 / 10), "slow")

    def test_what_touches_the_trigger_region_or_runs_backwards_does_not_count(self):
        self.assertEqual(front_type(front([None, 1.0, 300.0, -5.0, None, None])), "fast")

    def test_what_does_not_arrive_is_arrested(self):
        self.assertEqual(front_type(front([None] * 6, arrives=False)), "arrested")

    def test_what_cannot_be_prepared_has_no_type(self):
        self.assertEqual(front_type(None), "impossible")


class Boundary(unittest.TestCase):
    # tau_bar_0 upwards, sigma_bar to the right:  slow     fast
    #                                             arrested slow
    GRID = {(0.0, 0.0): "arrested", (0.0, 0.2): "slow", (0.1, 0.0): "slow", (0.1, 0.2): "fast"}

    def test_neighbours_are_along_both_axes(self):
        self.assertEqual(len(list(neighbours(self.GRID))), 4)

    def test_halfway_places_are_free_of_rounding_noise(self):
        self.assertEqual(middle(((0.1, 0.2), (0.2, 0.2))), (0.15, 0.2))

    def test_all_neighbours_of_other_type_are_changes(self):
        self.assertEqual(len(changes(self.GRID)), 4)

    def test_only_the_edge_of_the_fast_region_is_refined(self):
        self.assertEqual(to_refine(self.GRID), [(0.05, 0.2), (0.1, 0.1)])

    def test_nothing_changes_towards_what_cannot_be_prepared(self):
        self.assertEqual(changes({(0.0, 0.0): "fast", (0.1, 0.0): "impossible"}), [])

    def test_the_place_halfway_decides_which_neighbour_is_at_the_boundary(self):
        pair = {(0.0, 0.0): "arrested", (0.1, 0.0): "slow"}
        self.assertEqual(boundary(pair, {}), [(0.0, 0.0), (0.1, 0.0)])
        self.assertEqual(boundary(pair, {(0.05, 0.0): "slow"}), [(0.0, 0.0), (0.05, 0.0)])

    def test_a_third_type_halfway_makes_two_boundaries(self):
        pair = {(0.0, 0.0): "arrested", (0.1, 0.0): "fast"}
        self.assertEqual(len(boundary(pair, {(0.05, 0.0): "slow"})), 3)


class Order(unittest.TestCase):
    def test_a_fast_seed_below_left_of_an_arrested_one_is_found(self):
        seeds = {(0.0, 0.1): {1: "slow", 2: "fast"}, (0.1, 0.1): {1: "arrested"}}
        self.assertEqual(fast_below_left_of_arrested(seeds), [((0.0, 0.1), (0.1, 0.1))])

    def test_seeds_of_one_place_count(self):
        self.assertTrue(fast_below_left_of_arrested({(0.0, 0.0): {1: "fast", 2: "arrested"}}))

    def test_a_fast_point_at_wider_phi_is_in_order(self):
        seeds = {(0.0, 0.2): {1: "fast"}, (0.1, 0.1): {1: "arrested"}}
        self.assertEqual(fast_below_left_of_arrested(seeds), [])


class Claims(unittest.TestCase):
    def fronts(self, seeds):
        """20 x 20 places: arrested, slow and fast with rising tau_bar_0."""
        slow, fast = [None, None, 1.0, None, None, None], [None, None, 300.0, None, None, None]
        kinds = [front(slow, arrives=False)] * 5 + [front(slow)] * 5 + [front(fast)] * 10
        return {
            (t / 20, s / 20): dict.fromkeys(seeds, kinds[t]) for t in range(20) for s in range(20)
        }

    def judge(self, seeds):
        grid, fronts = self.fronts([1]), self.fronts(seeds)
        return holds("4D", [measured(fronts, grid, [(0.2, 0.0), (0.25, 0.0)], [])])

    def test_five_seeds_at_the_boundary_are_enough_and_four_are_not(self):
        self.assertTrue(self.judge(range(1, 6)))
        self.assertFalse(self.judge(range(1, 5)))


class RankTests(unittest.TestCase):
    def test_the_share_counts_pairs_of_equal_strata_only(self):
        self.assertEqual(share_of_lower([([1.0], [2.0]), ([5.0], [6.0])]), 1.0)
        self.assertEqual(share_of_lower([([1.0, 2.0], [1.5, 2.0])]), 0.625)
        self.assertIsNone(share_of_lower([([1.0], [])]))

    def test_one_stratum_is_the_mann_whitney_test(self):
        random = np.random.default_rng(1)
        first, second = random.normal(size=12), random.normal(0.5, size=9)
        expected = mannwhitneyu(
            first, second, alternative="less", method="asymptotic", use_continuity=False
        )
        self.assertAlmostEqual(van_elteren([(first, second)])["p"], expected.pvalue, places=12)

    def test_equal_groups_show_nothing(self):
        self.assertAlmostEqual(van_elteren([([1.0, 2.0], [1.0, 2.0])])["p"], 0.5)


if __name__ == "__main__":
    unittest.main()
