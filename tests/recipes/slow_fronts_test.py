"""Slow slip behind slow fronts on prepared interfaces: windows, seeds, claims 3C and 3D
(recipes/fig3)."""

import json

import front_speed
import slow_fronts
import slow_slip
from chains.chain import Chain
from chains.results import Result
from claims import paper
from conftest import ROOT, approx
from slow_fronts import fit_through_origin


def slips(blocks=5):
    """A report of `analyze slow-slip`."""
    return {
        "blocks": blocks,
        "front_speed": 10.0,
        "speed": {"mean": 1e-3, "min": 0.9e-3, "max": 1.1e-3},
        "estimate": 2e-3,
        "per_block": {"x": [2.0, 2.5], "speed": [0.9e-3, 1.1e-3], "v_c": [9.0, 11.0]},
    }


NOTHING_ELSE: dict = {"elements": {}, "commands": [], "base": None}


class TestFit:
    def test_through_the_origin_is_compared_with_the_mean(self):
        assert fit_through_origin([1, -2], [3, -6]).slope == 3
        # slope (1*3 + 2*3 + 3*6)/14; residuals (15, -12, 3)/14, sum of squares 27/14, of 6 about 4
        fit = fit_through_origin([1, 2, 3], [3, 3, 6])
        assert fit.slope == approx(27 / 14)
        assert fit.r_squared == approx(1 - 27 / 14 / 6)
        assert fit_through_origin([1, 2, 3], [3, 2, 1]).r_squared < 0
        assert fit_through_origin([1], [1]) is None
        assert fit_through_origin([1, 2, 4], [3, 12, 48]).exponent == approx(2)
        assert fit_through_origin([1, 2], [3, -6]).exponent is None
        assert fit.largest == approx(3 / (27 / 14) - 1)


class TestFronts:
    def test_fronts_count_that_slow_down_with_five_blocks_in_the_window(self, tmp_path):
        slow, fast = ({"type": kind} | slips() for kind in ("slow", "fast"))
        points: list[Result] = []
        for reports in ({"slow_slip": slow, "two_t_R": slips(blocks=4)}, {}, {"slow_slip": fast}):
            found = {"status": "done", "sentence": "", "reports": reports, "checksums": {}}
            path = tmp_path / f"{len(points)}.json"
            path.write_text(json.dumps(found))
            element = {"values": {"numerics.seed": "1"}, "path": path} | NOTHING_ELSE
            points.append(Result("", [element]))
        (front,) = slow_fronts.fronts(points)
        assert front["slow slip [m/s]"] == 1e-3
        assert slow_fronts.fronts(points, slow_fronts.FOR_TWO_T_R) == []

    def test_windows_are_commands_of_the_chains(self):
        for name in ("slow_slip", "front_speed"):
            commands = Chain(ROOT / f"recipes/fig3/{name}.ini").commands
            assert "--longest 2 " in commands[slow_fronts.WINDOWS[slow_fronts.FOR_TWO_T_R]]
            for command in slow_fronts.WINDOWS.values():
                assert commands[command].startswith("analyze slow-slip ")

    def test_near_arrest_is_below_3_m_s(self):
        rows = [{"front speed [m/s]": v} for v in (2.9, 3.0, 10.0)]
        assert slow_fronts.without_near_arrest(rows) == rows[1:]


SET = [  # fronts of claim 3C-inset
    {"variant": name, "estimate [m/s]": x, "slow slip [m/s]": 0.9 * x}
    for name in ("t_R", "tau_slip", "k_i")
    for x in (1e-3, 2e-3)
]


class TestSlowSlip:
    def test_a_line_through_the_origin(self):
        case = slow_slip.fit_of(slow_slip.varied(SET))
        assert case["slope"] == approx(0.9)
        assert case["r_squared"] == approx(1)

    def test_each_quantity_has_to_vary(self):
        missing = dict.fromkeys(("slope", "r_squared", "exponent", "largest"))
        assert slow_slip.fit_of(slow_slip.varied(SET[1:])) == missing
        assert slow_slip.fit_of(slow_slip.varied(SET, "k_i and K")) == missing

    def test_neighbours(self):
        blocks = [10, 11, 13, 14]  # 11 and 13 are no neighbours
        x = [slow_slip.WIDTH * block for block in blocks]
        row = {"per_block": {"x": x, "speed": [1.0, 1.1, 3.0, 2.4]}}
        assert slow_slip.largest_ratio(row) == approx(1.25)
        row["per_block"]["speed"][0] = -1.0
        assert slow_slip.largest_ratio(row) is None
        assert slow_slip.neighbours([]) == {"largest": None, "of_all": []}


def front(model, *, factor, mu_d, sigma_bar="0.1"):
    """A front whose speed is `factor` times its scaled slow slip, as k_i = 100 and p = 1."""
    strength = (1 - 0.1) * (0.4 - mu_d)
    scaled = 100 * paper.L_0 / strength * 1e-3
    return {
        "variant": f"{model}, f_slip",
        "slider.F_N": str(front_speed.NX),
        "junctions.kappa": "100",
        "junctions.mu_s": "0.4",
        "junctions.mu_d": str(mu_d),
        "tau-bar": "0.1",
        "sigma-bar": sigma_bar,
        "slow slip [m/s]": 1e-3,
        "front speed [m/s]": factor * scaled,
    }


class TestFrontSpeed:
    full = [front("full", factor=0.8, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    simplified = [front("simplified", factor=0.5, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    wide = [front("full", factor=0.9, mu_d=mu_d, sigma_bar="0.2") for mu_d in (0.1, 0.2)]

    def test_one_factor_for_each_model(self):
        case = front_speed.scaling_of(self.full + self.simplified)
        assert (case["r_squared_full"], case["slope_full"]) == approx((1, 0.8))
        assert case["difference"] == approx(0.6)

    def test_a_model_without_fronts_counts_as_not_measured(self):
        case = front_speed.scaling_of(self.full)
        assert case["r_squared_simplified"] is None
        assert case["difference"] is None

    def test_another_width_is_that_of_the_full_model_alone(self):
        rows = front_speed.with_width(self.full + self.simplified, self.wide, 0.2)
        assert rows == self.simplified + self.wide
        difference = front_speed.scaling_of(rows)["difference"]
        assert difference == approx(0.8)
