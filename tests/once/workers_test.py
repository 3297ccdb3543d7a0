"""Commands on four workers of a Dask scheduler on this machine, which are killed."""

import importlib.util
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from conftest import skip, wait_for
from endings_test import sleeping
from rupture import once
from rupture.commands.workers import SCHEDULER, programs_of
from rupture.errors import Failure, MachineFailure
from rupture.once import each, run

pytest_plugins = "laboratory"

if not importlib.util.find_spec("distributed"):
    skip("Commands on several machines need python3-distributed.")
WORKERS = 4
LONG = """each(lambda n: run(f"analyze stress --sleep 60 --x {n}"), range(9))"""


class Allocation:
    """A scheduler, and workers that know it from its file."""

    def __init__(self, folder):
        self.folder, self.file = folder, folder / "scheduler.json"
        self.file.unlink(missing_ok=True)  # of one that was killed
        self.started = []
        self.scheduler = self.start("scheduler", "--port", 0)
        self.start("worker", "--nworkers", WORKERS, "--nthreads", 1)

    def start(self, kind, *options):
        words = [sys.executable, "-m", "dask", kind, "--scheduler-file", self.file, *options]
        log = open(self.folder / f"{kind}-{len(self.started)}.log", "wb")
        streams = {"stdout": log, "stderr": log, "cwd": self.folder}
        process = subprocess.Popen([*map(str, words), "--no-dashboard"], **streams)
        self.started.append(process)
        return process

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in reversed(self.started):
            process.terminate()
        for process in self.started:
            process.wait(30)


@pytest.fixture(scope="module", name="shared")
def shared_by_tests(tmp_path_factory):
    with Allocation(tmp_path_factory.mktemp("allocation")) as allocation:
        yield allocation


@pytest.fixture(name="workers")
def workers_of_a_call(lab, shared, monkeypatch):
    monkeypatch.setenv(SCHEDULER, str(shared.file))
    executor = lab.call(cores=None).executor
    wait_for(lambda: executor.cores == WORKERS)
    return shared


def parent_of(number):
    status = Path(f"/proc/{number}/status").read_text()
    return int(re.findall(r"^PPid:\s*(\d+)", status, re.M)[0])


def worker_that_runs(words):
    """The process that has started a program."""
    lines = [line.split(None, 1) for line in os.popen("ps -e -o pid,args").read().splitlines()]
    [number] = [int(number) for number, line in lines if words in line and "python" not in line]
    return parent_of(number)


def test_results_are_those_of_one_machine(lab, workers):
    table = lab.write("t.csv", "a")

    def point(n):
        start = run(f"load {table} --x {n} -o a.h5", keep=["a.h5"])["a.h5"]
        after = run(f"restart {start} -o b.h5 --record r.h5", keep=["r.h5"])
        return run(f"analyze front {after['r.h5']}"), open(after["b.h5"]).read()

    def refused(code):
        return run(f"analyze front {run(f'load --refuse {code} -o a.h5')['a.h5']}")

    def everything():
        found = each(point, range(8)), each(refused, [1, 2]).refused, run("analyze diff --differ")
        lab.call(**here)
        kept = {n: b for n, b in lab.stored().items() if not n.endswith("json")}
        return found, kept

    here: dict = {"cores": None}
    afar = everything()
    os.rename(lab.store, lab.folder / "afar")
    here = {"executor": once.Local()}
    lab.call(**here)
    assert everything() == afar and len(afar[1]) == 16
    assert not [*Path(workers.folder).rglob("*.h5")]


def test_a_call_says_that_it_waits_for_workers(lab, workers, monkeypatch, capsys):
    monkeypatch.setattr("rupture.commands.workers.PAUSE", 0.2)
    making, said = lab.call(cores=WORKERS), ""

    def point(n):
        nonlocal said
        if n:
            return run("analyze stress").said
        workers.started[-1].terminate()
        wait_for(lambda: not making.executor.client.scheduler_info()["workers"])
        time.sleep(1)
        said = capsys.readouterr().err
        return workers.start("worker", "--nworkers", WORKERS, "--nthreads", 1)

    each(point, range(2))
    assert said.count("waiting for workers: none is left at the scheduler of ") == 1


def test_the_command_of_a_killed_worker_is_done_by_another(lab, workers):
    def point(n):
        if n == 0:
            wait_for(lambda: len(sleeping(lab)) == 4)
            os.kill(worker_that_runs("analyze stress --sleep 2 --x 1"), signal.SIGKILL)
            return None
        return run(f"analyze stress --sleep 2 --x {n}").said

    lab.call(cores=5)
    found = each(point, range(5))
    assert found[1:] == [((n,), f"analyze stress --sleep 2 --x {n}") for n in range(1, 5)]
    assert sorted(lab.ran()).count("analyze stress --sleep 2 --x 1") == 2


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_programs_end_with_their_call(lab, workers, number):
    with lab.start(LONG) as it:
        wait_for(lambda: len(sleeping(lab)) == 2)
        it.send_signal(number)
        said = it.communicate(timeout=20)[1]
    assert it.returncode in (128 + number, -number)
    assert number == signal.SIGKILL or said.endswith("goes on from there\n")
    assert "Traceback" not in said
    wait_for(lambda: not sleeping(lab))


def test_a_killed_scheduler_ends_the_call_and_the_next_one_goes_on(lab, workers):
    def point(n):
        return run(f"analyze stress --sleep {5 * n} --x {n}").said

    def point_or_end(n):
        if n < 2:
            return point(n)
        wait_for(lambda: lab.stored("*.json") and sleeping(lab))
        return workers.scheduler.kill()

    sentence = "the scheduler of .*/scheduler.json has ended: start .* the same call goes on"
    with pytest.raises(MachineFailure, match=sentence):
        each(point_or_end, range(3))
    wait_for(lambda: not sleeping(lab))
    assert sorted(lab.ran()) == ["analyze stress --sleep 0 --x 0", "analyze stress --sleep 5 --x 1"]
    with Allocation(workers.folder):
        lab.call(cores=3)
        assert len(each(point, range(2))) == 2
        once.finish()
    assert lab.ran() == ["analyze stress --sleep 5 --x 1"]


@pytest.mark.parametrize(
    "threads, gigabytes, needs, programs",
    [(8, 0, (1024, 1), 8), (8, 3, (1024, 1), 3), (8, 64, (1024, 3), 2), (2, 1, (4096, 4), 1)],
)
def test_a_worker_runs_what_it_has_threads_and_memory_for(threads, gigabytes, needs, programs):
    worker = {"nthreads": threads, "memory_limit": gigabytes * 2**30}
    assert programs_of(worker, *needs) == programs


def test_without_dask_or_a_scheduler_a_sentence_says_what_to_do(lab, monkeypatch):
    monkeypatch.setattr("rupture.commands.workers.WITHIN", 0.1)
    monkeypatch.setenv(SCHEDULER, "nothing.json")
    with pytest.raises(Failure, match="there is no .*/nothing.json: start dask scheduler"):
        lab.call()
    lab.write("nothing.json", '{"address": "tcp://127.0.0.1:9"}')
    with pytest.raises(Failure, match="the scheduler of .*/nothing.json does not answer"):
        lab.call()
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(Failure, match="needs Dask: sudo apt-get install python3-distributed"):
        lab.call()
