"""What is measured of prepared interfaces beside Figure 3: the decay length ahead of slow fronts
(recipes/fig3/decay_length.py), and fronts without a slipping force (no_slip_force.py)."""

import math
from types import SimpleNamespace

import numpy as np
from pytest import mark

from claims_test import copied
from conftest import approx
from examples import METHODS, front
from fig3 import decay_length, lengths, no_slip_force
from measure.ways import WAYS, PRIMARY
from measure.front_map import IMPOSSIBLE, front_type

DX = 3e-3  # [m]
BLOCKS = 16
TAU_0 = 3.0

EXPONENTIAL = 5 * np.exp(-np.arange(9) / 2.0)
UNEVEN = np.exp(-np.array([0, 1, 2, 4, 14, 24.0]))  # each fit uses its own blocks
LENGTHS = [  # the method, the excess ahead of the tip, and its decay length [blocks]
    *((method, EXPONENTIAL, 2.0) for method in decay_length.METHODS.values()),
    # 1, 0.5, 0: falls to 1/e at 1 + (0.5 - 1/e)/0.5, on a straight line between blocks
    (decay_length.distance_to_1_over_e, [2.0, 1.0, 0.0], 2 - 2 / math.e),
    # slope: (1.5 * 0 + 0.5 * 1 - 0.5 * 2 - 1.5 * 4)/(2 * 1.5^2 + 2 * 0.5^2) = -1.3
    (decay_length.exponential(0, 3), UNEVEN, 1 / 1.3),
    (decay_length.exponential(3, 5), UNEVEN, 0.1),
    # What does not decay has none.
    (decay_length.exponential(0, 3), [1.0, 0.5, 0.0, 0.1], None),
    (decay_length.exponential(0, 3), [1.0, 2, 3, 4], None),
    (decay_length.distance_to_1_over_e, [1.0, 0.9, 0.8], None),
]


@mark.parametrize("method, excess, length", LENGTHS)
def test_the_decay_length_of_a_profile(method, excess, length):
    assert method(np.array(excess)) == (length and approx(length))


def record(rupture_of):
    """A front that ruptures block n at time n, and moves the force on n up to 1 above tau_0 half a
    time before, falling by 1/e per block ahead; right at its rupture half of that is left."""
    time = np.arange(0, BLOCKS, 0.5)
    tau = np.full((len(time), BLOCKS), TAU_0)
    for sample, t in enumerate(time[1:], 1):
        tip = math.ceil(t)
        ahead = np.arange(BLOCKS) - tip
        height = 0.5 if t == tip else 1.0
        tau[sample, ahead >= 0] += height * np.exp(-ahead[ahead >= 0])
    slow = {"x_from": 3 * DX, "x_to": 12 * DX}
    x = (DX * np.arange(BLOCKS)).tolist()
    return {"type": "slow", "x": x, "t_rupture": rupture_of, "slow": slow}, time, tau


class TestOneFront:
    RUPTURES: list = [float(n) for n in range(BLOCKS)]

    def test_tips_are_in_the_slow_stretch_with_all_blocks_of_the_profile_ahead(self):
        front, *_ = record(self.RUPTURES)
        assert decay_length.tips(front) == [3, 4, 5, 6, 7]  # 7 + 8 is the last block

    def test_a_profile_is_that_of_the_largest_force_before_the_rupture(self):
        _, time, tau = record(self.RUPTURES)
        excess = decay_length.profile(4, self.RUPTURES, time, tau)
        np.testing.assert_allclose(excess, np.exp(-np.arange(9.0)))

    def test_a_block_that_ruptures_before_the_one_behind_has_no_profile(self):
        _, time, tau = record(self.RUPTURES)
        ruptures = [*self.RUPTURES[:4], 2.0, *self.RUPTURES[5:]]
        assert decay_length.profile(4, ruptures, time, tau) is None
        ruptures = [*self.RUPTURES[:3], None, *self.RUPTURES[4:]]
        assert decay_length.profile(4, ruptures, time, tau) is None

    def test_lengths_are_in_metres_and_medians(self):
        front, time, tau = record(self.RUPTURES)
        tau[9, 5:] += np.exp(-np.arange(BLOCKS - 5) / 3)  # when the force on block 5 is largest
        found = decay_length.of_front(front, time, tau)
        assert found["profiles"] == 5
        assert found["l_0"][PRIMARY] == approx(DX)
        assert found["excess"][1] == approx(1 / math.e)

    def test_a_front_that_is_not_slow_has_none(self):
        front, time, tau = record(self.RUPTURES)
        for other in ({"type": "arrested"}, {"slow": None}):
            found = decay_length.of_front(front | other, time, tau)
            assert (found["profiles"], found["l_0"][PRIMARY]) == (0, None)


def front_with(l_0, **others):
    return copied({"l_0": METHODS | {PRIMARY: l_0} | others, "profiles": 2 if l_0 else 0})


class TestSeveralFronts:
    def test_they_count_equally_and_those_without_a_length_not(self):
        fronts = [front_with(1e-3 * x) for x in (1, 2, 9)]
        fronts.insert(1, front_with(None, **{"fall to 1/e": 5e-3, "5 blocks ahead": 2e-3}))
        found = lengths.length(fronts, PRIMARY)
        assert [*found.values()] == [approx(2), 3, 6, approx([1, 9]), approx([2, 5])]
        assert lengths.length(fronts, "fall to 1/e")["l_0 [mm]"] == approx(5)
        assert [*lengths.length(fronts[1:2], PRIMARY).values()][:4] == [None, 0, 0, None]


class TestNoSlipForce:
    NEARLY_SLOW = front("fast", **{"slow below c_s/10": "slow"})
    FRONTS = [NEARLY_SLOW, front("fast"), front("arrested"), None]
    NARROW, WIDE, REFERENCE = (
        {name: {"slow": 0.1, "fast": 0.1 + width} for name in WAYS}
        for width in (0.001, 0.004, 0.06)
    )
    BANDS = [(NARROW, REFERENCE), (NARROW | {"stencil 3": WIDE[PRIMARY]}, REFERENCE)]

    @mark.parametrize(
        "way, widest, kinds",
        [
            (PRIMARY, 1 / 60, (1, 0, 2)),
            ("slow below c_s/10", 1 / 60, (1, 1, 1)),
            ("stencil 3", 1 / 15, (1, 0, 2)),  # at one of the sigma_bar
        ],
    )
    def test_types_and_the_widest_band_in_each_way(self, way, widest, kinds):
        of = SimpleNamespace(fronts=self.FRONTS, bands=self.BANDS)
        found = no_slip_force.types(of, way)
        assert [*found.values()] == approx([4, *kinds, widest])

    def test_the_slowest_stencil_beyond_the_trigger_region_of_a_front_that_spans(self):
        of: dict = {
            "x": [0.01, 0.03, 0.04, 0.05],
            "v_c": [1.0, 300.0, 90.0, -1.0],
            "t_rupture": [1.0],
        }
        of["criteria"] = {"skip_below_x": 0.02}
        arrested = of | {"t_rupture": [None]}
        assert [no_slip_force.slowest(one) for one in (of, arrested, None)] == [90, None, None]

    def test_what_cannot_be_prepared_is_impossible(self):
        assert front_type(None) == IMPOSSIBLE


class TestStiffness:
    def test_l_0_is_compared_in_the_order_of_k_over_k_i(self):
        """It goes with the square root of k/k_i, which goes with that of 1/kappa."""
        l_0 = [7e-3 * (lengths.KAPPA / kappa) ** 0.25 for kappa in lengths.KAPPAS]
        fronts = [front_with(x, **{"fall to 1/e": 7e-3}) for x in l_0]
        found = lengths.by_stiffness(fronts, PRIMARY)
        assert found["k/k_i over the reference's"] == approx([0.5, 0.5**0.5, 1, 2**0.5, 2])
        assert found["l_0 [mm]"] == approx([1e3 * x for x in l_0])
        assert found["exponent"] == approx(0.5)
        assert found["each longer than the one before"]
        other = lengths.by_stiffness(fronts, "fall to 1/e")
        assert not other["each longer than the one before"]

    def test_fronts_that_are_not_slow_do_not_count(self):
        found = lengths.by_stiffness([front_with(x) for x in (None,) * 4 + (7e-3,)], PRIMARY)
        assert found["slow fronts"] == 1 and not found["each longer than the one before"]
        assert math.isnan(found["exponent"])
