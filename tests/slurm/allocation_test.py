"""Figures and a sweep in an allocation of a real SLURM, as users submit them, with kills.

Each run has a copy of the project's recipes, so that no result is found twice.
"""

import functools
import importlib.util
import json
import os
import shutil
import signal
from pathlib import Path

import pytest

import conftest
from cluster import missing_programs, processes_with, running_cluster
from conftest import BIN as PROGRAMS, ROOT, skip
from stand_ins import Project

if missing_programs():
    skip(f"SLURM cannot be started without {', '.join(missing_programs())}.")
if not importlib.util.find_spec("distributed"):
    skip("Commands on several machines need python3-distributed.")
CORES = 2
FIGURES = ("figS3", "estimate")  # in seconds
WITHIN = 600  # [s] a run, however slow the machine
wait_for = functools.partial(conftest.wait_for, within=WITHIN)


class Copy(Project):
    within = WITHIN

    def __init__(self, folder, environment=os.environ):
        super().__init__(folder, environment)
        shutil.copytree(ROOT / "checkpoints", folder / "checkpoints")

    def results(self):
        return [*self.root.glob("results/store/??/*.json")]

    def checksums_behind(self, figure):
        """{command: checksums of its files}"""
        jobs = (self.root / f"results/{figure}/jobs.jsonl").read_text().splitlines()
        return {job["id"]: job.get("checksums", {}) for job in map(json.loads, jobs)}


@pytest.fixture(scope="module")
def cluster():
    with running_cluster(CORES) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    project = Copy(tmp_path_factory.mktemp("local"))
    assert project.call(*FIGURES, "--programs", PROGRAMS).returncode == 0
    return project


@pytest.fixture(name="project")
def project_on_slurm(tmp_path, cluster):
    return Copy(tmp_path, cluster.environment)


class Job:
    def __init__(self, project, cluster, *words):
        self.project, self.cluster = project, cluster
        command = ("sbatch", "--parsable", f"--cpus-per-task={CORES}", "--output=job.out")
        script = ("recipes/reproduce/slurm/job.sh", *words, "--programs", PROGRAMS)
        done = project.call(*command[1:], *script, command=command[0])
        assert done.returncode == 0, done.stderr
        self.number = done.stdout.strip()

    def is_in_queue(self):
        return self.number in self.cluster.run("squeue", "--noheader", "--format=%A").split()

    def wait_for_results(self, count):
        wait_for(lambda: len(self.project.results()) >= count or not self.is_in_queue())
        assert self.is_in_queue(), "the job ended too early"

    def wait_for_end(self):
        """What it has printed."""
        wait_for(lambda: not self.is_in_queue())
        output = (self.project.root / "job.out").read_text()
        print(output)
        return output

    def kill(self, words):
        """Those processes of the job whose command has these words."""
        for number in processes_with(f"SLURM_JOB_ID={self.number}\0".encode()):
            if words in Path(f"/proc/{number}/cmdline").read_bytes().decode().replace("\0", " "):
                os.kill(number, signal.SIGKILL)


def test_figures_survive_kills_and_are_those_of_one_machine(project, local, cluster):
    job = Job(project, cluster, *FIGURES)
    job.wait_for_results(50)  # of which most are digests of modules
    job.kill("dask scheduler")
    output = job.wait_for_end()
    assert "has ended: start scheduler and workers again" in output
    there = len(project.results())
    job = Job(project, cluster, *FIGURES)
    job.wait_for_results(there + 2)
    job.kill("multiprocessing")  # its worker, which is started again
    assert "\nDone in " in job.wait_for_end()
    count = 0
    for figure in FIGURES:
        found, expected = (one.checksums_behind(figure) for one in (project, local))
        assert found == expected, figure
        count += sum(map(len, found.values()))
        path = f"results/{figure}/claims.json"
        assert (project.root / path).read_bytes() == (local.root / path).read_bytes()
    assert count > 10
    print(f"the commands, the checksums of {count} files, and all tables of claims are equal")
