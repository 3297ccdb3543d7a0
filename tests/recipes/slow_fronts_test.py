#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Slow slip behind slow fronts on prepared interfaces: windows, seeds, claims 3Ci, 3D and co
(recipes/fig3)."""

import json
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "recipes"), str(ROOT / "recipes/fig3")]

import front_speed  # noqa: E402
import measure_slow_slip  # noqa: E402
import slow_fronts  # noqa: E402
import slow_slip  # noqa: E402
from claims import paper  # noqa: E402
from events.conventions import PRIMARY  # noqa: E402

# Slow stencils are those around blocks 2 to 8, so the stretch without its ends is 4 to 6.
FRONT = {
    "x": [0.5 * i for i in range(12)],
    "t_rupture": [float(i) for i in range(12)],
    "slow": {"x_from": 2.0, "x_to": 3.0, "t_to": 6.0},
}


def slips(t_to, blocks=5):
    return {
        "slow": {"t_to": t_to},
        "blocks": blocks,
        "front_speed": 10.0,
        "speed": {"mean": 1e-3, "min": 0.9e-3, "max": 1.1e-3},
        "estimate": 2e-3,
        "per_block": {"x": [2.0, 2.5], "speed": [0.9e-3, 1.1e-3], "v_c": [9.0, 11.0]},
    }


class Windows(unittest.TestCase):
    def analyze(self, t_to, narrow=slips(6.0)):
        """Measures as the program does; t_to is when the stretch of a cut record ends."""
        self.calls: list[list[str]] = []

        def call(command, _, words):
            if command == "front":
                return FRONT
            self.calls.append(words)
            return slips(t_to) if "--to" in words else narrow

        return call

    def test_the_time_ends_with_the_last_slow_stencil(self):
        found = measure_slow_slip.windows(self.analyze(8.0), "record.h5")
        self.assertEqual({*found}, {*slow_fronts.WINDOWS, slow_fronts.NARROW})
        primary = self.calls[1]
        for option, value in ("--to", 10.0), ("--x-from", 2.0), ("--x-to", 3.0):
            self.assertEqual(primary[primary.index(option) + 1], str(value))

    def test_a_stretch_that_ends_elsewhere_is_not_measured(self):
        found = measure_slow_slip.windows(self.analyze(9.0), "record.h5")
        self.assertEqual({*found}, {slow_fronts.NARROW})

    def test_without_blocks_inside_nothing_is(self):
        none = slips(0.0) | {"slow": None}
        self.assertEqual(measure_slow_slip.windows(self.analyze(8.0, none), "record.h5"), {})


class Fronts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "slow_slip-windows.json"

    def write(self, *rows):
        self.path.write_text(json.dumps(rows), encoding="utf-8")

    def test_fronts_count_that_slow_down_with_five_blocks_in_the_window(self):
        narrow = {PRIMARY: slips(0.0), slow_fronts.NARROW: slips(0.0, blocks=4)}
        self.write(
            {"type": "slow", "windows": narrow},
            {"type": "slow", "windows": {}},
            {"type": "fast", "windows": {PRIMARY: slips(0.0)}},
        )
        (front,) = slow_fronts.fronts(self.path)
        self.assertEqual(front["slow slip [m/s]"], 1e-3)
        self.assertEqual(slow_fronts.fronts(self.path, slow_fronts.NARROW), [])

    def test_near_arrest_is_below_3_m_s(self):
        rows = [{"front speed [m/s]": v} for v in (2.9, 3.0, 10.0)]
        self.assertEqual(slow_fronts.without_near_arrest(rows), rows[1:])

    def test_a_seed_needs_the_files_of_all_sweeps(self):
        paths = ["a-windows.json", "b-windows.json", "x/a-seed-12-windows.json"]
        units = slow_fronts.of_seeds(paths, lambda a, b: (a, b), ["a", "b"])
        self.assertEqual(units, {"seed 1": ("a-windows.json", "b-windows.json")})
        units = slow_fronts.of_seeds(paths, str, ["a"])
        self.assertEqual(list(units), ["seed 1", "seed 12"])


def run(variant, estimate, speed):
    """A front of claim 3Ci."""
    return {"variant": variant, "estimate [m/s]": estimate, "slow slip [m/s]": speed}


SET = [run(name, x, 0.9 * x) for name in ("t_R", "tau_slip", "k_i alone") for x in (1e-3, 2e-3)]


class SlowSlip(unittest.TestCase):
    def test_a_line_through_the_origin(self):
        case = slow_slip.case_3Ci(slow_slip.varied(SET))
        self.assertAlmostEqual(case["slope"], 0.9)
        self.assertAlmostEqual(case["R^2"], 1)

    def test_each_quantity_has_to_vary(self):
        missing = {"slope": None, "R^2": None}
        self.assertEqual(slow_slip.case_3Ci(slow_slip.varied(SET[1:])), missing)
        self.assertEqual(slow_slip.case_3Ci(slow_slip.varied(SET, "k_i and K")), missing)

    def test_neighbours(self):
        blocks = [10, 11, 13, 14]  # 11 and 13 are no neighbours
        x = [slow_slip.WIDTH * block for block in blocks]
        row = {"per_block": {"x": x, "speed": [1.0, 1.1, 3.0, 2.4]}}
        self.assertAlmostEqual(slow_slip.largest_ratio(row), 1.25)
        row["per_block"]["speed"][0] = -1.0
        self.assertIsNone(slow_slip.largest_ratio(row))
        self.assertIsNone(slow_slip.case_co([])["largest ratio of neighbours"])


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


class FrontSpeed(unittest.TestCase):
    full = [front("full", factor=0.8, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    simplified = [front("simplified", factor=1.0, mu_d=mu_d) for mu_d in (0.1, 0.2)]
    wide = [front("full", factor=0.9, mu_d=mu_d, sigma_bar="0.2") for mu_d in (0.1, 0.2)]

    def test_one_factor_for_each_model(self):
        case = front_speed.case_3D(self.full + self.simplified)
        self.assertAlmostEqual(case["R^2, full"], 1)
        self.assertAlmostEqual(case["difference of the slopes"], 0.2)

    def test_a_model_without_fronts_counts_as_not_measured(self):
        case = front_speed.case_3D(self.full)
        self.assertIsNone(case["R^2, simplified"])
        self.assertIsNone(case["difference of the slopes"])

    def test_another_width_is_that_of_the_full_model_alone(self):
        rows = front_speed.with_width(self.full + self.simplified, self.wide, 0.2)
        self.assertEqual(rows, self.simplified + self.wide)
        difference = front_speed.case_3D(rows)["difference of the slopes"]
        self.assertAlmostEqual(difference, 0.1)


if __name__ == "__main__":
    unittest.main()
