"""Figures in an allocation of a real SLURM, and a sweep with everything killed.

Each run has a copy of the project's recipes, so that no result is found twice.
"""

import functools
import json
import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

import stand_ins
from cluster import missing_programs, processes_with, running_cluster
from conftest import BIN as PROGRAMS, ROOT, skip
from stand_ins import Project

if missing_programs():
    skip(f"SLURM cannot be started without {', '.join(missing_programs())}.")
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
wait_for = functools.partial(stand_ins.wait_for, within=WITHIN)


class Sweep(Project):
    """`environment` is that of the cluster, if it has one."""

    within = WITHIN

    def __init__(self, folder, environment=os.environ):
        super().__init__(folder, environment)
        shutil.copytree(ROOT / "checkpoints", folder / "checkpoints")
        self.write("my.ini", SWEEP)

    def run(self, command, *words):
        """What was printed."""
        done = self.call(*words, command=command, stderr=subprocess.STDOUT)
        assert done.returncode == 0, done.stdout
        return done.stdout

    def points(self):
        """{name: result} of the points that are done or have failed."""
        done = (path.with_suffix(".json") for path in self.stored(".origin"))
        return {path.name: path.read_bytes() for path in done}


def reproduce(*arguments):
    return ["./reproduce.sh", *arguments, "--programs", PROGRAMS]


def in_allocation(*arguments):
    """The command that takes an allocation and runs in it."""
    allocation = ("salloc", "--quiet", f"--ntasks={CORES}", "--mem-per-cpu=1000M")
    return (*allocation, *reproduce(*arguments), "--profile", "slurm")


@pytest.fixture(scope="module")
def cluster():
    with running_cluster(CORES) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    """The sweep without SLURM."""
    project = Sweep(tmp_path_factory.mktemp("local"))
    project.run(*reproduce("sweep", "my.ini"))
    assert len(project.points()) == POINTS
    return project


@pytest.fixture(name="project")
def project_on_slurm(tmp_path, cluster):
    return Sweep(tmp_path, cluster.environment)


class Job:
    """The sweep as users submit it: the file that they change is a batch script."""

    def __init__(self, project, cluster):
        self.project, self.cluster = project, cluster
        job = ("sbatch", "--parsable", f"--ntasks={CORES}", "--output=job.out")
        script = ("recipes/reproduce/slurm/job.sh", "sweep", "my.ini", "--programs", PROGRAMS)
        self.number = project.run(*job, *script).strip()

    def is_in_queue(self):
        return self.number in self.cluster.run("squeue", "--noheader", "--format=%A").split()

    def wait_for_points(self, count):
        wait_for(lambda: len(self.project.points()) >= count or not self.is_in_queue())
        assert self.is_in_queue(), "the job ended too early"

    def wait_for_end(self):
        """What it has printed."""
        wait_for(lambda: not self.is_in_queue())
        output = (self.project.root / "job.out").read_text()
        print(output)
        return output

    def steps(self):
        """The steps that run commands; the batch script is a step, too."""
        steps = self.cluster.run("squeue", "--noheader", "--steps", "--format=%i").split()
        return [step for step in steps if re.fullmatch(rf"{self.number}\.\d+", step)]

    def be_noted(self):
        """slurmctld notes its jobs every few seconds; when killed, it forgets younger ones."""
        state = self.cluster.folder / "state/job_state"
        since = time.time()
        self.cluster.run("scontrol", "update", f"jobid={self.number}", "comment=noted")
        wait_for(lambda: state.exists() and state.stat().st_mtime > since)

    def kill_all(self):
        """Every process that was started in the project's folder, at once."""
        mark = f"PYTHONPATH={self.project.root}/recipes:".encode()
        for number in processes_with(mark):
            os.kill(number, signal.SIGKILL)


def test_a_sweep_survives_everything(project, local, cluster):
    job = Job(project, cluster)
    job.wait_for_points(3)
    cluster.run("scancel", wait_for(job.steps)[0])
    job.wait_for_points(6)
    job.be_noted()
    for daemon in cluster.processes.values():
        daemon.kill()  # at once, as a power cut would
        daemon.wait()
    time.sleep(3)
    cluster.launch_daemons()
    job.wait_for_points(9)
    job.kill_all()
    cluster.run("scancel", job.number)  # if SLURM has put it into the queue again
    job.wait_for_end()
    there = len(project.points())
    assert there < POINTS
    output = Job(project, cluster).wait_for_end()
    assert f"Computed now: {POINTS - there}; already done: {there}." in output
    assert f"{POINTS} points: {POINTS - REFUSED} done, {REFUSED} failed." in output
    assert project.points() == local.points()
    for table in ("results/sweeps/my/my.csv", "results/sweeps/my/my.hdf5"):
        assert (project.root / table).read_bytes() == (local.root / table).read_bytes()
    print(f"{POINTS} points and 2 tables are those of the local run")


def test_an_interruption_ends_all_steps(project, cluster):
    salloc, *words = in_allocation("sweep", "my.ini")
    process = project.start(*words, command=salloc, start_new_session=True)
    wait_for(lambda: project.points() or process.poll() is not None)
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    os.kill(int(children[0]), signal.SIGINT)
    process.communicate(timeout=30)
    assert process.returncode == 130
    assert cluster.run("squeue", "--noheader", "--steps") == ""


def checksums_behind(project, figure):
    """{command: checksums of its files}"""
    jobs = (project.root / f"results/{figure}/jobs.jsonl").read_text().splitlines()
    return {job["id"]: job.get("checksums", {}) for job in map(json.loads, jobs)}


def test_figures_give_what_they_give_locally(project, local):
    figures = ("figS3", "estimate")  # in seconds
    project.run(*in_allocation(*figures))
    local.run(*reproduce(*figures))
    count = 0
    for figure in figures:
        found, expected = (checksums_behind(one, figure) for one in (project, local))
        assert found == expected, figure
        count += sum(map(len, found.values()))
        path = f"results/{figure}/claims.json"
        assert (project.root / path).read_bytes() == (local.root / path).read_bytes()
    assert count > 10
    print(f"the commands, the checksums of {count} files, and all tables of claims are equal")
