"""Sweeps and figures in allocations of a real SLURM, undisturbed and with everything killed.

Each run has a copy of the project's recipes, so that no result is found twice.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from cluster import Cluster, missing_programs
from conftest import BIN as PROGRAMS, ROOT, skip

if missing_programs():
    skip(f"SLURM cannot be started without {', '.join(missing_programs())}.")
COPIED = ("reproduce.sh", "packages.txt", "CITATION.cff", "recipes", "python", "checkpoints")
CORES = 2
SWEEP = """\
[sweep]
title  = Fronts on prepared interfaces
memory = 400 MB

[commands]
prepare = prepare --sigma-bar 0.1 {values} -o start.h5 --quiet
restart = restart start.h5 --for 0.025 -o end.h5 --record record.h5 --record-every 1ms --quiet
front   = analyze front record.h5 --json

[values]
tau-bar = 0.1, 0.2, 0.3, 5
seed    = 1 to 8

[quantities]
type       = front.type
slow speed = front.slow.speed
"""
POINTS = 32
REFUSED = 8  # no distribution of junction forces carries tau-bar = 5
WITHIN = 600  # [s] a run, however slow the machine


def environment_of(folder):
    """The environment a process was started with; empty if it has ended or is another user's."""
    try:
        return (folder / "environ").read_bytes()
    except OSError:
        return b""


class Project:
    """A copy of what a run needs."""

    def __init__(self, folder):
        self.root = Path(folder)
        self.root.mkdir()
        for name in COPIED:
            source = ROOT / name
            if source.is_dir():
                shutil.copytree(source, self.root / name)
            else:
                shutil.copy2(source, self.root / name)
        (self.root / "my.ini").write_text(SWEEP)

    def start(self, *command, environment=None):
        return subprocess.Popen(
            command,
            cwd=self.root,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )

    def run(self, *command, environment=None):
        """Exit code, what was printed, and seconds."""
        started = time.monotonic()
        process = self.start(*command, environment=environment)
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
        return [(folder / name).read_bytes() for name in ("my.csv", "my.hdf5")]

    def sums(self):
        """Of the checkpoints and records of figures, and of the points."""
        folder = self.root / "results/data"
        return {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*.sum")}


class OnSlurm(unittest.TestCase):
    folder: Path
    cluster: Cluster
    local: Project
    local_seconds: float

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="rupture-slurm-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "cluster").mkdir()
        cls.cluster = cls.enterClassContext(Cluster(cls.folder / "cluster", CORES))
        cls.local = Project(cls.folder / "local")
        code, output, cls.local_seconds = cls.local.run(*cls.reproduce("sweep", "my.ini"))
        assert code == 0, output

    @staticmethod
    def reproduce(*arguments):
        return ["./reproduce.sh", *arguments, "--programs", PROGRAMS]

    def project(self, name):
        return Project(self.folder / name)

    def in_allocation(self, *arguments):
        """The command that takes an allocation and runs in it."""
        allocation = ("salloc", "--quiet", f"--ntasks={CORES}", "--mem-per-cpu=1000M")
        return (*allocation, *self.reproduce(*arguments), "--profile", "slurm")

    def run_on_slurm(self, project, *arguments):
        command = self.in_allocation(*arguments)
        return project.run(*command, environment=self.cluster.environment)

    def submit(self, project):
        """The file that users change is a batch script."""
        job = ("sbatch", "--parsable", f"--ntasks={CORES}", "--output=job.out")
        script = ("recipes/common/profiles/slurm/job.sh", "sweep", "my.ini", "--programs", PROGRAMS)
        command = (*job, *script)
        return project.run(*command, environment=self.cluster.environment)[1].strip()

    def is_in_queue(self, job):
        return job in self.cluster.run("squeue", "--noheader", "--format=%A").split()

    def wait_for(self, condition):
        end = time.monotonic() + WITHIN
        while not (met := condition()):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        return met

    def demand_equal_sweeps(self, project):
        self.assertEqual(len(self.local.points()), POINTS)
        self.assertEqual(project.points(), self.local.points())
        self.assertEqual(project.tables(), self.local.tables())
        checksums = project.checksums()
        self.assertEqual(checksums, self.local.checksums())
        print(
            f"{len(checksums)} checksums, {POINTS} points and 2 tables are equal"
            " to those of the local run"
        )

    def test_a_sweep_gives_what_it_gives_locally(self):
        project = self.project("undisturbed")
        code, output, seconds = self.run_on_slurm(project, "sweep", "my.ini")
        self.assertEqual(code, 0, output)
        self.demand_equal_sweeps(project)
        print(f"sweep: local {self.local_seconds:.1f} s, SLURM {seconds:.1f} s")
        self.assertIn(f"{POINTS} points: {POINTS - REFUSED} done, {REFUSED} failed.", output)
        self.assertIn(f"{POINTS}/{POINTS} point: ", output)

    def test_a_sweep_survives_everything(self):
        project = self.project("disturbed")
        job = self.submit(project)
        self.wait_for_points(project, 3, job)
        self.cancel_a_step(job)
        self.wait_for_points(project, 6, job)
        self.let_slurm_note(job)
        for daemon in ("slurmctld", "slurmd"):
            self.cluster.kill(daemon)
        time.sleep(3)
        self.cluster.launch("slurmctld", "-D")
        self.cluster.launch("slurmd", "-D", "-N", self.cluster.host)
        self.wait_for_points(project, 9, job)
        self.kill_all_of(project)
        self.cluster.run("scancel", job)  # if SLURM has put it into the queue again
        self.wait_for(lambda: not self.is_in_queue(job))
        print("killed all of the job. It had printed:")
        print((project.root / "job.out").read_text())
        there = len(project.points())
        self.assertLess(there, POINTS)
        job = self.submit(project)
        self.wait_for(lambda: not self.is_in_queue(job))
        output = (project.root / "job.out").read_text()
        print(output)
        self.assertEqual(len(project.points()), POINTS)
        self.assertIn(f"Computed now: {POINTS - there}; there before: {there}.", output)
        self.demand_equal_sweeps(project)

    def wait_for_points(self, project, count, job):
        self.wait_for(lambda: len(project.points()) >= count or not self.is_in_queue(job))
        self.assertTrue(self.is_in_queue(job), "the job ended too early")

    def let_slurm_note(self, job):
        """slurmctld notes its jobs every few seconds; when killed, it forgets younger ones."""
        state = self.folder / "cluster/state/job_state"
        since = time.time()
        self.cluster.run("scontrol", "update", f"jobid={job}", "comment=noted")
        self.wait_for(lambda: state.exists() and state.stat().st_mtime > since)

    def steps_of(self, job):
        """Those of commands; the batch script is a step, too."""
        steps = self.cluster.run("squeue", "--noheader", "--steps", "--format=%i").split()
        return [step for step in steps if re.fullmatch(rf"{job}\.\d+", step)]

    def cancel_a_step(self, job):
        steps = self.wait_for(lambda: self.steps_of(job))
        self.cluster.run("scancel", steps[0])

    def kill_all_of(self, project):
        """Every process that was started in the project's folder, at once."""
        mark = f"PYTHONPATH={project.root}/recipes/common:".encode()
        for folder in Path("/proc").glob("[0-9]*"):
            if mark in environment_of(folder):
                os.kill(int(folder.name), signal.SIGKILL)

    def test_an_interruption_ends_all_steps(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number.name):
                self.interrupt(number, code)

    def interrupt(self, number, code):
        project = self.project(f"ended by {number.name}")
        process = project.start(
            *self.in_allocation("sweep", "my.ini"), environment=self.cluster.environment
        )
        self.wait_for(lambda: project.points() or process.poll() is not None)
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        os.kill(int(children[0]), number)
        process.communicate(timeout=30)
        self.assertEqual(process.returncode, code)
        self.assertEqual(self.cluster.run("squeue", "--noheader", "--steps"), "")

    def test_figures_give_what_they_give_locally(self):
        figures = ("fig2", "figS3", "figS4", "estimate")  # events, points, widened phi: in seconds
        project = self.project("figures")
        code, output, seconds = self.run_on_slurm(project, *figures)
        self.assertEqual(code, 0, output)
        code, output, local_seconds = self.local.run(*self.reproduce(*figures))
        self.assertEqual(code, 0, output)
        local = {name: text for name, text in self.local.sums().items() if "sweeps/" not in name}
        local = {name: text for name, text in local.items() if "bases/" not in name}
        self.assertGreater(len(local), 15)
        self.assertEqual(project.sums(), local)
        for figure in figures:
            claims = [each.root / f"results/{figure}/claims.json" for each in (project, self.local)]
            self.assertEqual(*[path.read_bytes() for path in claims])
        ratio = seconds / local_seconds
        times = f"local {local_seconds:.1f} s, SLURM {seconds:.1f} s, {ratio:.2f} times"
        print(f"{' '.join(figures)}: {times}")
        print(f"{len(local)} files of checksums and all tables of claims are equal")
