"""Slow slip behind slow fronts on prepared interfaces: windows, claims 3C and 3D (recipes/fig3)."""

from math import isnan

from rupture.once import Report

import paper
from claims_test import copied
from conftest import approx
from fig3 import front_speed, slow_slip
from fig3 import slow_fronts as slow
from measure.ways import PRIMARY


def slips(kind="slow", blocks=5, speed=10.0):
    """A report of `analyze slow-slip`."""
    return {
        "blocks": blocks,
        "front_speed": speed,
        "speed": {"mean": 1e-3, "min": 0.9e-3, "max": 1.1e-3} if blocks else None,
        "estimate": 2e-3,
        "per_block": {"x": [2.0, 2.5], "speed": [0.9e-3, 1.1e-3], "v_c": [9.0, 11.0]},
        "type": kind,
    }


def row(kind="slow", fewer=5, **others):
    """A front, which has fewer blocks in the last window."""
    windows = dict.fromkeys(slow.WINDOWS, slips(kind, **others))
    *_, last = windows
    return copied({"type": kind, "windows": windows | {last: slips(kind, fewer)}})


class TestFit:
    def test_through_the_origin_is_compared_with_the_mean(self):
        through = slow.fit_through_origin
        assert through([1, -2], [3, -6]).slope == 3
        # slope (1*3 + 2*3 + 3*6)/14; residuals (15, -12, 3)/14, sum of squares 27/14, of 6 about 4
        fit = through([1, 2, 3], [3, 3, 6])
        assert fit.slope == approx(27 / 14)
        assert fit.r_squared == approx(1 - 27 / 14 / 6)
        assert through([1, 2, 3], [3, 2, 1]).r_squared < 0
        assert through([1], [1]) is slow.NO_FIT and isnan(slow.NO_FIT.slope)
        assert through([1, 2, 4], [3, 12, 48]).exponent == approx(2)
        assert isnan(through([1, 2], [3, -6]).exponent)
        assert fit.largest == approx(3 / (27 / 14) - 1)
        assert fit.offset == approx(1)  # of 1.5 x + 1

    def test_the_interval_of_an_exponent_is_of_fronts_that_are_drawn(self):
        """Two fronts at each of two places. Drawn with replacement, the exponents are 1, 2 and 3
        where one front of each place is drawn, and otherwise between."""
        fit = slow.fit_through_origin([1, 1, 2, 2], [1, 2, 4, 8])
        assert slow.exponent_interval(fit) == approx([1, 3])


class TestFronts:
    def test_fronts_count_that_slow_down_with_five_blocks_in_the_window(self):
        found = slow.by_way([row(fewer=4), row("fast"), row(fewer=0, blocks=0)])
        first, *windows, _ = found.values()
        assert [front["slow slip [m/s]"] for front in first] == [1e-3]
        assert [len(rows) for rows in windows] == [1] * (len(slow.WINDOWS) - 2) + [0]

    def test_a_front_that_is_not_slow_in_a_way_does_not_count_in_it(self):
        front = row()
        front["windows"]["stencil 3"] = copied(slips("fast"))
        found = slow.by_way([front])
        assert [way for way, rows in found.items() if not rows] == ["stencil 3"]

    def test_near_arrest_is_below_3_m_s(self):
        found = slow.by_way([row(speed=v) for v in (2.9, 3.0, 10.0)])[slow.WITHOUT_NEAR_ARREST]
        assert [front["front speed [m/s]"] for front in found] == [3, 10]

    def test_parameters_vary_together(self):
        """k_i is proportional to the square root of kappa p."""
        of = front_speed.parameters(1, **{"slider.E": 6e9, "junctions.t_R": 4e-3})
        assert (of["junctions.kappa"], of["junctions.delta_t_R"]) == approx((4 * 39.2e9, 1.2e-3))
        assert of["numerics.dt"] == approx(2e-7 / 2**0.5, abs=1e-15)
        of = front_speed.parameters(1, **{"slider.F_N": 3840, "junctions.mu_d": 0.34})
        assert (of["junctions.kappa"], of["junctions.mu_s"]) == approx((39.2e9 / 2, 0.8))


SET = [  # fronts of claim 3C-inset
    {"variant": name, "estimate [m/s]": x, "slow slip [m/s]": 0.9 * x}
    for name in ("t_R", "tau_slip", "k_i")
    for x in (1e-3, 2e-3)
]


class TestSlowSlip:
    def test_a_line_through_the_origin(self):
        fit = slow_slip.fit_of(slow_slip.varied(SET))
        assert (fit.slope, fit.r_squared) == approx((0.9, 1))

    def test_each_quantity_has_to_vary(self):
        assert slow_slip.fit_of(slow_slip.varied(SET[1:])) is slow.NO_FIT
        assert slow_slip.fit_of(slow_slip.varied(SET, "k_i and K")) is slow.NO_FIT

    def test_neighbours(self):
        blocks = [10, 11, 13, 14]  # 11 and 13 are no neighbours
        x = [slow_slip.WIDTH * block for block in blocks]
        front: dict = {"variant": "k_i", "per_block": {"x": x, "speed": [1.0, 1.1, 3.0, 2.4]}}
        assert slow_slip.largest_ratio(front) == approx(1.25)
        found = slow_slip.neighbours(Report(rows={PRIMARY: [front]}), PRIMARY)
        assert [*found.values()] == [None, 1, 0]
        front["per_block"]["speed"][0] = -1.0
        assert isnan(slow_slip.largest_ratio(front))
        reference = front | {"variant": "reference"}
        reference["per_block"] = {"x": x[:2], "speed": [1.0, 1.2]}
        found = slow_slip.neighbours(Report(rows={PRIMARY: [front, reference]}), PRIMARY)
        assert [*found.values()] == [1.2, 2, 1]


def front(model, *, factor, mu_d, sigma_bar=0.1):
    """A front whose speed is `factor` times its scaled slow slip, as k_i = 100 and p = 1."""
    strength = (1 - 0.1) * (0.4 - mu_d)
    scaled = 100 * paper.L_0 / strength * 1e-3
    return {
        "variant": f"{model}, f_slip",
        "slider.F_N": front_speed.NX,
        "junctions.kappa": 100,
        "junctions.mu_s": 0.4,
        "junctions.mu_d": mu_d,
        "tau-bar": 0.1,
        "sigma-bar": sigma_bar,
        "slow slip [m/s]": 1e-3,
        "front speed [m/s]": factor * scaled,
    }


class TestFrontSpeed:
    full = [front("full", factor=0.8, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    simplified = [front("simplified", factor=0.5, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    wide = [front("full", factor=0.9, mu_d=mu_d, sigma_bar=0.2) for mu_d in (0.1, 0.2)]

    def case(self, rows):
        return front_speed.scaling({PRIMARY: front_speed.fits_of(rows)}, PRIMARY)

    def test_one_factor_for_each_model(self):
        case = self.case(self.full + self.simplified)
        assert (case["R^2, full"], case["slope, full"]) == approx((1, 0.8))
        assert case["difference of the slopes"] == approx(0.6)

    def test_beside_it_stand_fronts_of_10_m_s_or_more_and_speeds_without_scaling(self):
        """The faster ones have twice the slip and four times the speed: the exponent is 2."""
        slow_ones = [f | {"front speed [m/s]": v} for f, v in zip(self.full, (2.0, 9.9))]
        faster = [f | {"front speed [m/s]": v} for f, v in zip(self.full[:1] * 2, (10.0, 40.0))]
        faster[1] = faster[1] | {"slow slip [m/s]": 2e-3}
        found = front_speed.fits_of(slow_ones + faster)
        assert found["full, faster"].exponent == approx(2)
        assert len(found["full"].x) == 4 and [*found["full, unscaled"].x] == [
            1e-3,
            1e-3,
            1e-3,
            2e-3,
        ]

    def test_a_model_without_fronts_counts_as_not_measured(self):
        case = self.case(self.full)
        assert isnan(case["R^2, simplified"]) and isnan(case["difference of the slopes"])

    def test_another_width_is_that_of_the_full_model_alone(self):
        rows = front_speed.with_width(self.full + self.simplified, self.wide, 0.2)
        assert rows == self.simplified + self.wide
        assert self.case(rows)["difference of the slopes"] == approx(0.8)
