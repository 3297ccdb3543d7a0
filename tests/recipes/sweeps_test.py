"""Reading sweep files (common/sweeps/sweep.py) and computing points (batch.py, collect.py)."""

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
sys.path.insert(0, str(ROOT / "recipes/common"))

from sweeps.needs import Needs  # noqa: E402
from sweeps.point_store import PointStore  # noqa: E402
from sweeps.sweep import (  # noqa: E402
    Point,
    SweepError,
    batches_of,
    read_sweep,
    seeds_of,
    values_of,
)

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

    def test_the_same_again_with_another_seed(self):
        text = f"[sweep]\nseeds = 2, 3\n{COMMANDS}[values]\na = 1, 2\n[variant x]\nb = 3\n"
        first = self.read(text)
        path = Path(self.folder.name) / "sweep.ini"
        again = read_sweep(f"{path}#3")
        self.assertEqual(seeds_of(path), ["2", "3"])
        for one, other in zip(first.points, again.points, strict=True):
            self.assertEqual(other.values, one.values | {"numerics.seed": "3"})
            self.assertNotIn("numerics.seed", one.values)
        without = self.read(text.replace("seeds = 2, 3\n", ""))
        self.assertEqual([p.id for p in without.points], [p.id for p in first.points])
        self.assertEqual(seeds_of(path), [])

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

        self.assertEqual(needs(""), Needs(megabytes=1000, threads=1))
        found = needs("memory = 2.5 GB\nthreads = 4")
        self.assertEqual(found, Needs(megabytes=2500, threads=4))
        for text in ("memory = 10", "memory = 0 MB", "memory = 2 kg", "memory = .", "threads = 0"):
            with self.subTest(text), self.assertRaisesRegex(SweepError, "is not understood: give"):
                needs(text)

    def test_needs_and_title_do_not_name_points(self):
        points = [
            self.read(f"[sweep]\n{text}\n{COMMANDS}[values]\na = 1").points[0].id
            for text in ("", "memory = 3 GB\nthreads = 2\ntitle = T")
        ]
        self.assertEqual(points[0], points[1])


class Tables(unittest.TestCase):
    def test_a_recipe_reads_those_of_its_own_sweeps_only(self):
        sweeps = {f"{path.parent.name}/{path.stem}" for path in ROOT.glob("recipes/*/*.ini")}
        for rules in ROOT.glob("recipes/*/*.smk"):
            text = rules.read_text(encoding="utf-8")
            for table in re.findall(r"\{DATA\}/([\w/-]+)\.csv|tables_of_seeds\(\"([^\"]+)", text):
                name = "".join(table)
                if name in sweeps:
                    self.assertEqual(name.split("/")[0], rules.parent.name, f"{rules}: {name}")


class Batches(unittest.TestCase):
    def test_every_point_is_in_one_batch(self):
        for number in (0, 1, 24, 64, 65, 859, 2000):
            batches = batches_of(list(range(number)))
            self.assertEqual(sorted(sum(batches, [])), list(range(number)))

    def test_short_sweeps_have_a_job_per_point_and_long_ones_at_most_60_points_per_job(self):
        self.assertEqual(len(batches_of(list(range(64)))), 64)
        self.assertEqual(max(map(len, batches_of(list(range(100_000))))), 60)

    def test_neighbours_are_apart(self):
        self.assertEqual(batches_of(list(range(130)))[0], [0, 44, 88])


class Computing(unittest.TestCase):
    """With a stand-in for the tools."""

    TOOL = (
        '#!/bin/sh\necho "$2" >> "$CALLS"\n'
        'case "$2" in bad) echo "tool: too large" >&2; exit 1;; $CRASH) kill -9 $$;; esac\n'
        'echo "content-sha256 abc  x.h5" > x.h5.sum; echo "{\\"v\\": {\\"w\\": [1, 2]}}"\n'
    )

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        tool = self.folder / "tool"
        tool.write_text(self.TOOL)
        tool.chmod(0o755)
        self.sweep = self.folder / "sweep.ini"
        self.calls = self.folder / "calls"

    def script(self, name, *arguments, crash="none"):
        environment = dict(
            os.environ,
            PYTHONPATH=f"{ROOT}/recipes/common:{ROOT}/python",
            CALLS=str(self.calls),
            CRASH=crash,
        )
        command = [sys.executable, ROOT / "recipes/common/sweeps" / name, *arguments]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    def batch(self, values, code="1", **options):
        """Computes all values; self.computed: those that were not there."""
        self.sweep.write_text(
            f"[sweep]\nbase = {self.folder}/base\n[commands]\nfirst = tool {{values}} --json\n"
            f"[values]\nkind = {values}\n[table]\nw = first.v.w.1\nnone = first.v.x.y\n"
        )
        (self.folder / "base").touch()
        self.calls.write_text("")
        ids = [point.id for point in read_sweep(self.sweep).points]
        arguments = (self.folder, self.sweep, self.folder, code, self.folder / "batch.sum")
        done = self.script("batch.py", *arguments, *ids, **options)
        self.computed = self.calls.read_text().split()
        return done

    def table(self):
        done = self.script("collect.py", self.sweep, self.folder, self.folder / "table.csv")
        if done.returncode:
            return done.stderr
        with open(self.folder / "table.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_a_failed_point_keeps_its_sentence(self):
        self.assertEqual(self.batch("good, bad").returncode, 0)
        good, bad = self.table()
        self.assertEqual((good["status"], good["w"], good["none"]), ("done", "2", ""))
        self.assertEqual((bad["status"], bad["sentence"]), ("failed", "tool: too large"))
        report = json.loads((self.folder / f"{good['point']}.json").read_text())
        self.assertEqual(report["checksums"], {"x.h5": "abc"})

    def test_the_digest_tells_results_apart_and_not_what_computed_them(self):
        self.batch("good")
        (point,) = self.table()
        path = self.folder / f"{point['point']}.json"
        for name, told_apart in (("origin", False), ("first", True)):
            changed = json.loads(path.read_text()) | {name: "other"}
            path.write_text(json.dumps(changed))
            (other,) = self.table()
            self.assertEqual(other["digest"] != point["digest"], told_apart)

    def test_nothing_but_failures_is_a_failure(self):
        self.batch("bad")
        self.assertIn("tool: too large", self.table())

    def test_a_crash_leaves_no_point_and_keeps_the_others(self):
        done = self.batch("a, b, c", crash="b")
        self.assertEqual((done.returncode, self.computed), (1, ["a", "b", "c"]))
        self.assertIn("ended with -9", done.stderr)
        self.assertEqual(len(list(self.folder.glob("*.json"))), 2)
        self.assertFalse((self.folder / "batch.sum").exists())
        (why,) = self.folder.glob("*.why")
        self.assertIn("ended with -9", why.read_text())
        self.assertEqual((self.batch("a, b, c").returncode, self.computed), (0, ["b"]))
        self.assertEqual(list(self.folder.glob("*.why")), [])

    def test_what_is_there_is_not_computed_again(self):
        self.batch("a, b")
        first = (self.folder / "batch.sum").read_text()
        self.batch("a, b, c")
        self.assertEqual(self.computed, ["c"])
        self.assertTrue((self.folder / "batch.sum").read_text().startswith(first))

    def test_other_sources_or_another_base_compute_anew_and_equal_results_say_so(self):
        self.batch("a")
        first = (self.folder / "batch.sum").read_text()
        self.batch("a", code="2")
        self.assertEqual(self.computed, ["a"])
        (self.folder / "base").write_text("other")
        self.batch("a", code="2")
        self.assertEqual(self.computed, ["a"])
        self.assertEqual((self.folder / "batch.sum").read_text(), first)

    def test_a_damaged_result_is_computed_anew(self):
        self.batch("a")
        (path,) = self.folder.glob("*.json")
        for text in ("", "[]", "null", '{"status": "done"}'):
            path.write_text(text)
            self.batch("a")
            self.assertEqual(self.computed, ["a"], text)

    def test_an_interruption_ends_it_at_once(self):
        tool = self.folder / "tool"
        tool.write_text('#!/bin/sh\necho "$2" >> "$CALLS"\nkill -INT $$\n')
        self.assertEqual((self.batch("a, b").returncode, self.computed), (130, ["a"]))


class Crashes(unittest.TestCase):
    def test_the_first_point_of_all_may_crash(self):
        with tempfile.TemporaryDirectory() as folder:
            store = PointStore(f"{folder}/none/yet", "code")
            point = Point({}, {}, "")
            store.note_crash(point, "why")
            self.assertEqual(store.crash(point), "why")
            store.save(point, {})
            self.assertEqual(store.crash(point), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
