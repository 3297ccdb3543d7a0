"""A user's sweep from its file to its table, by ./reproduce.sh: what fails, what crashes, what is
computed when the file changes (recipes/common/sweeps/, recipes/common/sweeps/sweep.smk)."""

import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("RUPTURE_BIN", ROOT / "build/release/bin"))

# Small and fast. A prestress of 2 is more than junctions can carry.
SMALL = "--set slider.Nx=15 --set slider.Nz=9 --set slider.H=0.08 --set driving.h=0.01"
SWEEP = f"""[sweep]
title = Prestress
{{threads}}

[commands]
prepare = prepare --sigma-bar 0.1 --set numerics.dt=1e-6 {SMALL} {{{{values}}}} -o start.h5 --quiet
restart = restart start.h5 --for 1e-4 -o end.h5 --record record.h5 --quiet
front   = analyze front record.h5 --json

[values]
tau-bar = {{values}}

[quantities]
type = front.type
{{quantities}}
"""

# Stands in for restart: dies like a process without memory where the test says so.
RESTART = """#!/bin/sh
case "$RUPTURE_CRASH $*" in *--describe) ;; die*) kill -9 $$;; esac
exec {restart} "$@"
"""


class Running(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in ("recipes", "python"):
            shutil.copytree(ROOT / name, self.root / name)
        for name in ("reproduce.sh", "packages.txt"):
            shutil.copy2(ROOT / name, self.root / name)
        tools = self.root / "bin"
        tools.mkdir()
        for tool in ("analyze", "load", "modify-phi", "prepare"):
            (tools / tool).symlink_to(BIN / tool)
        (tools / "restart").write_text(RESTART.format(restart=BIN / "restart"), encoding="utf-8")
        (tools / "restart").chmod(0o755)

    def call(self, *arguments, crash=""):
        return subprocess.run(
            [self.root / "reproduce.sh", "sweep", "own.ini", "--programs", "bin", *arguments],
            cwd=self.root,
            env=dict(os.environ, RUPTURE_CRASH=crash),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )

    def sweep(self, values, quantities="", threads="", crash=""):
        """The finished command; self.computed: how many points it has computed."""
        path = self.root / "own.ini"
        text = SWEEP.format(values=values, quantities=quantities, threads=threads)
        path.write_text(text, encoding="utf-8")
        done = self.call(crash=crash)
        self.computed = int(re.findall(r"Computed now: (\d+);", done.stdout)[0])
        return done

    def rows(self):
        with open(self.root / "results/sweeps/own/own.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def files(self):
        return {path.suffix for path in (self.root / "results/sweeps/own").iterdir()}

    def test_from_a_crash_to_a_whole_table_that_grows_and_shrinks(self):
        crashed = self.sweep("0.1, 2", crash="die")
        crash, refused = self.rows()
        self.assertEqual((crash["status"], refused["status"]), ("unfinished", "failed"))
        self.assertRegex(crash["sentence"], "^'restart start.h5 .*' ended with -9$")
        self.assertIn("Failed: point: tau-bar 0.1", crashed.stderr)
        self.assertRegex(refused["sentence"], "^prepare: tau-bar = 2 would put junctions beyond")
        self.assertEqual(crashed.returncode, 1)
        self.assertIn("2 points: 1 failed, 1 unfinished.", crashed.stdout)
        self.assertIn("The same command tries unfinished points again.", crashed.stderr)
        self.assertEqual(self.files(), {".ini", ".csv", ".hdf5", ".png", ".pdf"})

        again = self.sweep("0.1, 2")
        self.assertEqual((again.returncode, again.stderr, self.computed), (0, "", 1))
        self.assertIn(
            "2 points: 1 done, 1 failed.\nComputed now: 1; there before: 1.", again.stdout
        )
        self.assertEqual(self.rows()[0]["type"], "none")

        self.sweep("0.1, 2, 0.2", quantities="x = front.x_arrest\nL = front.L")
        self.assertEqual(self.computed, 1, "of a new value and new quantities, only the value")
        self.assertEqual([row["L [m]"] for row in self.rows()], ["0.14", "", "0.14"])

        self.sweep("0.2")
        said = self.call("--dry-run")
        self.assertEqual(said.stdout, "Prestress: 1 point, 1 there, 0 to compute.\n")

        last = self.sweep("0.2", threads="threads = 2\nmemory = 2 GB")
        self.assertEqual(self.computed, 0, "a point less, and other needs")
        self.assertEqual([row["tau-bar"] for row in self.rows()], ["0.2"])
        self.assertIn("Computed now: 0; there before: 1.", last.stdout)

    def test_the_counter_ends_at_the_number_of_jobs(self):
        counts = re.findall(r"\] +(\d+)/(\d+) ", self.sweep("0.1, 0.2, 2").stdout)
        self.assertEqual(counts, [("1", "3"), ("2", "3"), ("3", "3")])

    def test_a_result_that_was_deleted_is_computed_again(self):
        self.sweep("0.1, 0.2")
        next((self.root / "results/data/points").glob("*.json")).unlink()
        self.assertIn("2 points, 1 there, 1 to compute.", self.call("--dry-run").stdout)
        done = self.sweep("0.1, 0.2")
        self.assertEqual((done.returncode, self.computed), (0, 1))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
