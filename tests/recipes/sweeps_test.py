"""Reading sweep files (recipes/common/sweeps.py) and computing points (point.py, collect.py)."""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "recipes"))

from common.needs import Needs  # noqa: E402
from common.sweeps import SweepError, read_sweep, values_of  # noqa: E402

COMMANDS = "[commands]\nstart = prepare {values} -o start.h5\n"


class Reading(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def read(self, text):
        path = Path(self.folder.name) / "sweep.ini"
        path.write_text(text, encoding="utf-8")
        return read_sweep(path)

    def values(self, text):
        return [point.values for point in self.read(f"[sweep]\n{COMMANDS}{text}").points]

    def test_ranges_include_both_ends(self):
        self.assertEqual(values_of("0 to 0.4 by 0.1"), ["0", "0.1", "0.2", "0.3", "0.4"])
        self.assertEqual(values_of("0 to 0.3 in 4"), ["0", "0.1", "0.2", "0.3"])
        self.assertEqual(values_of("5 to 1 by -2"), ["5", "3", "1"])
        self.assertEqual(values_of("2 to 2 in 1"), ["2"])
        self.assertEqual(values_of("1 to 3"), ["1", "2", "3"])

    def test_a_step_that_does_not_fit_stops_before_the_end(self):
        self.assertEqual(values_of("0 to 1 by 0.4"), ["0", "0.4", "0.8"])

    def test_lists_keep_what_is_written(self):
        self.assertEqual(values_of("1e-3, 0.002,bell"), ["1e-3", "0.002", "bell"])

    def test_wrong_ranges(self):
        for text in ("0 to 1 by 0", "0 to 1 by -1", "0 to x by 1", "0 to 1 in 0", "1,,2", ""):
            with self.subTest(text), self.assertRaises(SweepError):
                values_of(text)
        finite, many = "its numbers must be finite", "more than 100,000 values"
        wrong = {
            "1 to inf": finite,
            "0 to 1 in inf": finite,
            "0 to 1 in 1e400": finite,
            "0 to 1 by nan": finite,
            "-1e308 to 1e308": finite,
            "0 to 1 in 2.5": "must be whole",
            "0 to 1 in 1e300": many,
            "1 to 1e7": many,
            "1 to 1e300 by 1e-300": many,
            "1 to -1e300 by 1e-300": "no value in it",
        }
        for text, sentence in wrong.items():
            with self.subTest(text), self.assertRaisesRegex(SweepError, f"'{text}'.*{sentence}"):
                values_of(text)

    def test_the_number_of_points_is_limited(self):
        with self.assertRaisesRegex(SweepError, "1,000,000,000,000 points; at most 100,000"):
            self.values("".join(["[values]\n", *(f"{n} = 1 to 1e3\n" for n in "abcd")]))

    def test_every_combination_is_a_point(self):
        points = self.values("[values]\na = 1, 2\nb = 3, 4")
        expected = [("1", "3"), ("1", "4"), ("2", "3"), ("2", "4")]
        self.assertEqual([(p["a"], p["b"]) for p in points], expected)

    def test_expressions_follow_other_values(self):
        points = self.values("[values]\nc = sqrt({b})\nb = {a} ** 2 * 4\na = 1, 3")
        self.assertEqual([(p["b"], p["c"]) for p in points], [("4", "2"), ("36", "6")])

    def test_a_negative_value_stays_one_number_in_an_expression(self):
        self.assertEqual(self.values("[values]\na = -2\nb = {a} ** 2")[0]["b"], "4")

    def test_wrong_expressions(self):
        wrong = ("{a}", "{z} + 1", "__import__('os')", "{a}.real", "1 / 0 * {b}", "{b} +")
        for text in wrong:
            with self.subTest(text), self.assertRaises(SweepError):
                self.values(f"[values]\nb = 1\na = {text if '{' in text else text + ' * {b}'}")

    def test_expressions_without_a_finite_real_number_are_named(self):
        wrong = (
            "{b}**{b}**{b}**{b}",
            "sqrt({b} - 10)",
            "({b} - 10) ** 0.5",
            "{b} * 1e308 * 10",
            "{b} + x",
        )
        for text in wrong:
            expected = re.escape(f"sweep.ini: '{text}' ")
            with self.subTest(text), self.assertRaisesRegex(SweepError, expected):
                self.values(f"[values]\nb = 9\na = {text}")

    def test_variants_replace_common_values(self):
        points = self.values(
            "[values]\na = 1\nb = 2\n[variant one]\na = 5, 6\n[variant two]\nb = 7"
        )
        found = [(p["variant"], p["a"], p["b"]) for p in points]
        self.assertEqual(found, [("one", "5", "2"), ("one", "6", "2"), ("two", "1", "7")])

    def test_options_and_parameters(self):
        text = f"[sweep]\n{COMMANDS}[values]\ntau-bar = 0.1\njunctions.N_s = 5\n[variant v]\n"
        command = self.read(text).points[0].commands["start"]
        self.assertEqual(command, "prepare --tau-bar 0.1 --set junctions.N_s=5 -o start.h5")

    def test_points_from_a_table(self):
        table = Path(self.folder.name) / "points.csv"
        text = f"[sweep]\npoints = {table}\n{COMMANDS}[values]\nseed = 1, 2"
        self.assertEqual(self.read(text).points, [])
        table.write_text("a,b\n1,2\n3,4\n", encoding="utf-8")
        found = [(p.values["a"], p.values["b"], p.values["seed"]) for p in self.read(text).points]
        self.assertEqual(
            found, [("1", "2", "1"), ("1", "2", "2"), ("3", "4", "1"), ("3", "4", "2")]
        )

    def test_the_name_of_a_point_follows_from_its_commands_alone(self):
        few = self.read(f"[sweep]\ntitle = A\n{COMMANDS}[values]\na = 1").points
        many = self.read(f"[sweep]\ntitle = B\n{COMMANDS}[values]\na = 0, 1").points
        self.assertEqual(few[0].id, many[1].id)
        self.assertNotEqual(many[0].id, many[1].id)

    def test_what_is_wrong_is_said_with_the_file(self):
        whole = f"[sweep]\n{COMMANDS}"
        wrong = {
            "": "no section .sweep.",
            "[sweep]\n": "no section .commands.",
            f"{whole}x = load {{other}}\n": "may refer to {values} only",
            f"{whole}x = load {{values.x}}\n": "may refer to {values} only",
            "no section": "line 1 comes before the first section",
            f"{whole}[values]\na\n": "line 5 is neither",
            f"{whole}[values]\na = 1\na = 2\n": "'a' is in .values. twice",
            f"{whole}[values]\n[values]\n": "section .values. is there twice",
        }
        for text, sentence in wrong.items():
            with self.subTest(text), self.assertRaisesRegex(SweepError, f"sweep.ini: .*{sentence}"):
                self.read(text)

    def test_comments_may_follow_on_the_line(self):
        self.assertEqual(self.values("[values]\na = 1, 2  # both\n"), [{"a": "1"}, {"a": "2"}])

    def test_varied_are_values_that_differ_and_do_not_follow_others(self):
        sweep = self.read(f"[sweep]\n{COMMANDS}[values]\na = 1, 2\nb = 3\nc = 2 * {{a}}\nd = x, y")
        self.assertEqual(sweep.varied, ["a", "d"])

    def test_needs_of_a_point(self):
        def needs(text):
            return self.read(f"[sweep]\n{text}\n{COMMANDS}").needs

        self.assertEqual(needs(""), Needs(minutes=10, megabytes=1000, threads=1))
        found = needs("time = 1.5 h\nmemory = 2.5 GB\nthreads = 4")
        self.assertEqual(found, Needs(minutes=90, megabytes=2500, threads=4))
        self.assertEqual(needs("time = 61 s").minutes, 2)
        for text in ("time = 10", "time = 0 min", "memory = 2 kg", "memory = .", "threads = 0"):
            with self.subTest(text), self.assertRaisesRegex(SweepError, "is not understood: give"):
                needs(text)

    def test_needs_and_title_do_not_name_points(self):
        points = [
            self.read(f"[sweep]\n{text}\n{COMMANDS}[values]\na = 1").points[0].id
            for text in ("", "time = 1 h\nmemory = 3 GB\nthreads = 2\ntitle = T")
        ]
        self.assertEqual(points[0], points[1])


class Computing(unittest.TestCase):
    """With a stand-in for the tools."""

    TOOL = (
        '#!/bin/sh\nif [ "$1" = bad ]; then echo "tool: too large" >&2; exit 1; fi\n'
        'if [ "$1" = crash ]; then kill -9 $$; fi\n'
        'echo "abc  x.h5" > x.h5.sum; echo "{\\"v\\": {\\"w\\": [1, 2]}}"\n'
    )

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        tool = self.folder / "tool"
        tool.write_text(self.TOOL)
        tool.chmod(0o755)
        self.sweep = self.folder / "sweep.ini"

    def script(self, name, *arguments):
        environment = dict(os.environ, PYTHONPATH=str(ROOT / "recipes"))
        command = [sys.executable, ROOT / "recipes/common" / name, *arguments]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    def compute(self, first_values):
        self.sweep.write_text(
            "[sweep]\n[commands]\nfirst = tool {values} --json\n[values]\nkind = "
            f"{first_values}\n[table]\nw = first.v.w.1\nnone = first.v.x.y\n"
        )
        # The stand-in reads its first argument only.
        for point in read_sweep(self.sweep).points:
            line = point.commands["first"].replace("--kind ", "")
            done = self.script(
                "point.py", self.folder, self.folder / f"{point.id}.json", "", f"first={line}"
            )
            if done.returncode:
                return done
        return self.script("collect.py", self.sweep, self.folder, self.folder / "table.csv")

    def table(self):
        with open(self.folder / "table.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_a_failed_point_keeps_its_sentence(self):
        self.assertEqual(self.compute("good, bad").returncode, 0)
        good, bad = self.table()
        self.assertEqual((good["status"], good["w"], good["none"]), ("done", "2", ""))
        self.assertEqual((bad["status"], bad["sentence"]), ("failed", "tool: too large"))
        report = json.loads((self.folder / f"{good['point']}.json").read_text())
        self.assertEqual(report["checksums"], {"x.h5": "abc"})

    def test_nothing_but_failures_is_a_failure(self):
        done = self.compute("bad")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tool: too large", done.stderr)

    def test_a_crash_leaves_no_point(self):
        done = self.compute("crash")
        self.assertEqual(done.returncode, 128 + 9)
        self.assertIn("ended with -9", done.stderr)
        self.assertEqual(list(self.folder.glob("*.json*")), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
