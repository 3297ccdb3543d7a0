"""A sweep and a figure on a real SLURM: undisturbed, and with everything killed that can be.

    sweep_test.py FOLDER_OF_PROGRAMS

Each run has a copy of the project's recipes, so that no result is found twice.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from cluster import Cluster, missing_programs

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("reproduce.sh", "packages.txt", "recipes", "checkpoints")
JOBS = 4
GROUP = 4
SWEEP = """\
[sweep]
title   = Fronts on prepared interfaces
prepare = --sigma-bar 0.1
restart = --for 0.012 --record-every 1e-3
time    = 2 min
memory  = 400 MB

[values]
tau-bar = 0.1, 0.2, 0.3, 5
seed    = 1 to 6

[quantities]
type       = front.type
slow speed = front.slow.speed
"""
POINTS = 24
REFUSED = 6  # no distribution of junction forces carries tau-bar = 5
WITHIN = 600  # [s] a run, however slow the machine


def kill_session(number):
    """A process and all its descendants, but for those with a session of their own (srun)."""
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            session = (folder / "stat").read_text().rsplit(")", 1)[1].split()[3]
            if int(session) == number:
                os.kill(int(folder.name), signal.SIGKILL)
        except OSError:
            continue  # it has just ended


class Project:
    """A copy of what a run needs."""

    def __init__(self, folder):
        self.root = Path(folder)
        self.root.mkdir()
        for name in COPIED:
            source = ROOT / name
            copy = shutil.copytree if source.is_dir() else shutil.copy2
            copy(source, self.root / name)
        (self.root / "my.ini").write_text(SWEEP)
        profile = self.root / "recipes/profiles/slurm/srun.ini"
        text = re.sub("^jobs = .*", f"jobs = {JOBS}", profile.read_text(), flags=re.M)
        profile.write_text(re.sub("^group = .*", f"group = {GROUP}", text, flags=re.M))

    def start(self, *arguments, environment=None):
        return subprocess.Popen(
            ["./reproduce.sh", *arguments, "--programs", PROGRAMS],
            cwd=self.root,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )

    def run(self, *arguments, environment=None):
        """Exit code, what was printed, and seconds."""
        started = time.monotonic()
        process = self.start(*arguments, environment=environment)
        output = process.communicate(timeout=WITHIN)[0]
        return process.returncode, output, time.monotonic() - started

    def points(self):
        return {
            path.name: path.read_bytes()
            for path in (self.root / "results/data/points").glob("*.json")
        }

    def checksums(self):
        """Of every checkpoint and record that the points wrote."""
        reports = (json.loads(text) for _, text in sorted(self.points().items()))
        return [checksum for each in reports for checksum in each["checksums"].values()]

    def tables(self):
        folder = self.root / "results/sweeps/my"
        return [(folder / name).read_bytes() for name in ("my.csv", "my.h5")]

    def sums(self):
        """Of the checkpoints and records of figures."""
        return {path.name: path.read_text() for path in (self.root / "results/data").glob("*.sum")}

    def logs(self):
        return list(self.root.glob("results/log/slurm/*/*.log"))


class OnSlurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="rupture-slurm-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "cluster").mkdir()
        cls.cluster = cls.enterClassContext(Cluster(cls.folder / "cluster", 2))
        cls.local = Project(cls.folder / "local")
        code, output, cls.local_seconds = cls.local.run("sweep", "my.ini")
        assert code == 0, output

    def project(self, name):
        return Project(self.folder / name)

    def run_on_slurm(self, project, *arguments):
        return project.run(*arguments, "--profile", "slurm", environment=self.cluster.environment)

    def names_in_queue(self):
        return self.cluster.run("squeue", "--noheader", "--format=%j").split()

    def demand_equal_sweeps(self, project):
        self.assertEqual(len(self.local.points()), POINTS)
        self.assertEqual(project.points(), self.local.points())
        self.assertEqual(project.tables(), self.local.tables())
        checksums = project.checksums()
        self.assertEqual(checksums, self.local.checksums())
        print(
            f"{len(checksums)} checksums, {POINTS} points and 2 tables are equal to those of the local run"
        )

    def test_a_sweep_gives_what_it_gives_locally(self):
        project = self.project("undisturbed")
        code, output, seconds = self.run_on_slurm(project, "sweep", "my.ini")
        self.assertEqual(code, 0, output)
        self.demand_equal_sweeps(project)
        print(
            f"local {self.local_seconds:.1f} s, SLURM {seconds:.1f} s, {len(project.logs())} jobs"
        )
        self.assertIn(f"{POINTS} points: {POINTS - REFUSED} done, {REFUSED} failed.", output)
        self.assertLess(len(project.logs()), POINTS)
        self.demand_jobs_as_in_the_file()

    def demand_jobs_as_in_the_file(self):
        """What SLURM itself noted about the jobs."""
        job = self.cluster.run("scontrol", "--oneliner", "show", "job").splitlines()[-1]
        self.assertRegex(job, r"JobName=point-\d{4} ")
        self.assertIn("MinMemoryNode=400M", job)
        self.assertRegex(job, r"TimeLimit=00:0[2468]:00")  # 2 min for each of up to 4 points

    def test_a_sweep_survives_everything(self):
        project = self.project("disturbed")
        arguments = ("sweep", "my.ini", "--profile", "slurm")
        process = project.start(*arguments, environment=self.cluster.environment)
        self.wait_for_points(project, 3, process)
        self.cancel_a_job()
        self.wait_for_points(project, 6, process)
        for daemon in ("slurmctld", "slurmd"):
            self.cluster.kill(daemon)
        time.sleep(3)
        self.cluster.launch("slurmctld", "-D")
        self.cluster.launch("slurmd", "-D", "-N", self.cluster.host)
        self.wait_for_points(project, 9, process)
        kill_session(process.pid)
        print("killed ./reproduce.sh. It had printed:")
        print(process.communicate()[0])
        there = len(project.points())
        self.assertLess(there, POINTS)
        code, output, _ = self.run_on_slurm(project, "sweep", "my.ini")
        print(output)
        self.assertEqual(code, 0, output)
        self.assertEqual(len(project.points()), POINTS)
        computed = int(re.search(r"Computed now: (\d+)", output)[1])
        self.assertLessEqual(computed, POINTS - there + JOBS)  # what Snakemake had not noted yet
        self.demand_equal_sweeps(project)
        self.assertEqual(self.names_in_queue(), [])

    def wait_for_points(self, project, count, process):
        end = time.monotonic() + WITHIN
        while len(project.points()) < count:
            self.assertIsNone(process.poll(), "the run ended too early")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def cancel_a_job(self):
        running = self.cluster.run("squeue", "--noheader", "--states=R", "--format=%A").split()
        self.cluster.run("scancel", running[0])

    def test_an_interruption_ends_all_jobs(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number.name):
                self.interrupt(number, code)

    def interrupt(self, number, code):
        project = self.project(f"ended by {number.name}")
        arguments = ("sweep", "my.ini", "--profile", "slurm")
        process = project.start(*arguments, environment=self.cluster.environment)
        self.wait_for_points(project, 1, process)
        os.kill(process.pid, number)
        self.assertNotIn("ended", process.communicate(timeout=30)[0])  # by SLURM
        self.assertEqual(process.returncode, code)
        self.assertEqual(self.names_in_queue(), [])

    def test_a_figure_gives_what_it_gives_locally(self):
        project = self.project("figure")
        code, output, seconds = self.run_on_slurm(project, "fig2")
        self.assertEqual(code, 0, output)
        code, output, local_seconds = self.local.run("fig2")
        self.assertEqual(code, 0, output)
        self.assertEqual(len(project.sums()), 7)
        self.assertEqual(project.sums(), self.local.sums())
        claims = [each.root / "results/fig2/claims.json" for each in (project, self.local)]
        self.assertEqual(*[path.read_bytes() for path in claims])
        names = {path.stem.rsplit("-", 1)[0] for path in project.logs()}
        self.assertEqual(names, {"event_start", "event_compared", "event_record", "front", "fig2"})
        print(f"fig2: local {local_seconds:.1f} s, SLURM {seconds:.1f} s")


def demand_slurm():
    if missing := missing_programs():
        print(f"Skipped: SLURM cannot be started without {', '.join(missing)}.")
        sys.exit(1 if os.environ.get("CI") else 77)


if __name__ == "__main__":
    demand_slurm()
    PROGRAMS = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
