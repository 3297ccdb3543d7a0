"""A user's sweep from its file to its table, by ./reproduce.sh: what fails, what crashes, what is
computed when the file changes (recipes/common/sweeps/, recipes/common/sweeps/sweep.smk)."""

import csv
import os
import re
import subprocess

import pytest

from conftest import BIN
from stand_ins import Project

# Small and fast. A prestress of 2 is more than junctions can carry.
SMALL = "--set slider.Nx=15 --set slider.Nz=9 --set slider.H=0.08 --set driving.h=0.01"
SWEEP = f"""[sweep]
title = Prestress
{{needs}}

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
RESTART = f"""case "$RUPTURE_CRASH $*" in *--describe) ;; die*) kill -9 $$;; esac
exec {BIN}/restart "$@"
"""


class TestRunning:
    @pytest.fixture(autouse=True)
    def _project(self, tmp_path):
        project = Project(tmp_path)
        self.root = project.root
        for tool in ("analyze", "load", "modify-phi", "prepare"):
            (project.bin / tool).symlink_to(BIN / tool)
        project.program("restart", RESTART)

    def run_sweep(self, *arguments, crash=""):
        return subprocess.run(
            [self.root / "reproduce.sh", "sweep", "own.ini", "--programs", "bin", *arguments],
            cwd=self.root,
            env=os.environ | {"RUPTURE_CRASH": crash},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )

    def sweep(self, values, quantities="", needs="", crash=""):
        """The finished command; self.computed: how many points it has computed."""
        text = SWEEP.format(values=values, quantities=quantities, needs=needs)
        (self.root / "own.ini").write_text(text, encoding="utf-8")
        done = self.run_sweep(crash=crash)
        self.computed = int(re.findall(r"Computed now: (\d+);", done.stdout)[0])
        return done

    def rows(self):
        with open(self.root / "results/sweeps/own/own.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_from_a_crash_to_a_whole_table_that_grows_and_shrinks(self):
        crashed = self.sweep("0.1, 2", crash="die")
        crash, refused = self.rows()
        assert (crash["status"], refused["status"]) == ("unfinished", "failed")
        assert re.match("'restart start.h5 .*' ended with -9$", crash["sentence"])
        assert "Failed: point: tau-bar 0.1" in crashed.stderr
        assert refused["sentence"].startswith("prepare: tau-bar = 2 would put junctions beyond")
        assert crashed.returncode == 1
        assert "2 points: 1 failed, 1 unfinished." in crashed.stdout
        assert "The same command tries unfinished points again." in crashed.stderr
        files = {path.suffix for path in (self.root / "results/sweeps/own").iterdir()}
        assert files == {".ini", ".csv", ".hdf5", ".png", ".pdf"}
        assert re.findall(r"\] +(\d+)/(\d+) ", crashed.stdout)[-1] == ("2", "2")

        again = self.sweep("0.1, 2")
        assert (again.returncode, again.stderr, self.computed) == (0, "", 1)
        expected = "2 points: 1 done, 1 failed.\nComputed now: 1; there before: 1."
        assert expected in again.stdout
        assert self.rows()[0]["type"] == "none"

        self.sweep("0.1, 2, 0.2", quantities="x = front.x_arrest\nL = front.L")
        assert self.computed == 1, "of a new value and new quantities, only the value"
        assert [row["L [m]"] for row in self.rows()] == ["0.14", "", "0.14"]

        self.sweep("0.2")
        said = self.run_sweep("--dry-run").stdout
        assert said == "Prestress: 1 point, 1 there, 0 to compute.\n"

        last = self.sweep("0.2", needs="threads = 2\nmemory = 2 GB")
        assert self.computed == 0, "a point less, and other needs"
        assert [row["tau-bar"] for row in self.rows()] == ["0.2"]
        assert "Computed now: 0; there before: 1." in last.stdout

    def test_a_result_that_was_deleted_is_computed_again(self):
        self.sweep("0.1, 0.2")
        next((self.root / "results/data/points").glob("*.json")).unlink()
        assert "2 points, 1 there, 1 to compute." in self.run_sweep("--dry-run").stdout
        done = self.sweep("0.1, 0.2")
        assert (done.returncode, self.computed) == (0, 1)
