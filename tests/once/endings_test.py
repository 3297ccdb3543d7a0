"""How a call ends: signals, kills at any moment, two calls at a time, programs that go with it."""

import json
import os
import random
import signal
import time

import pytest

from conftest import wait_for

pytest_plugins = "laboratory"


MANY = """
from itertools import product
def front(n, m):
    start = run(f"load --seed {n} --sleep 0.01 -o a.h5", keep=["a.h5"])["a.h5"]
    after = run(f"restart {start} --x {m} --sleep 0.02 -o b.h5 --record r.h5", keep=["r.h5"])
    return run(f"analyze front {after['r.h5']}").read
def fronts(n):
    return len(each(lambda m: front(n, m), range(3)))
print(sum(found for _, found in each(fronts, range(4), "fronts")))
"""
LONG = """
from rupture.commands import processes
processes.WITH_US = ["not-there"]  # which ends programs, too
use(cores=2)
def point(n):
    print(run(f"analyze stress --sleep {60 if n else 0} --x {n}").said, flush=True)
each(point, range(9), "stress")
"""
AT_ONCE = """
import os, signal, subprocess, time
from rupture.commands import processes
processes.WITH_US = ["not-there"]
use(cores=2)
start = subprocess.Popen.__init__
def interrupted(*words, **options):
    start(*words, **options)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(0.2)
subprocess.Popen.__init__ = interrupted
run("analyze stress --sleep 60")
"""
KILLS = 20


def results(lab):
    """What is known of commands, but for times; and the files that are kept."""
    found = {}
    for name, content in lab.stored().items():
        if name.endswith(".json"):
            result = json.loads(content)
            if "command" not in result:  # seconds of points, which a killed call does not save
                continue
            keys = "command status code report checksums kept sentence".split()
            content = [result.get(key) for key in keys]
        found[name] = content
    return found


def sleeping(lab):
    """Programs that are there still."""
    lines = os.popen("ps -e -o args").read().splitlines()
    return [line for line in lines if f"{lab.folder}/bin/analyze" in line]


def test_kills_at_any_moment_leave_results_of_an_uninterrupted_call(lab):
    since = time.monotonic()
    assert lab.script(MANY)[:2] == (0, "12\n")
    lasting, wanted = time.monotonic() - since, results(lab)
    os.rename(lab.store, lab.folder / "whole")
    lab.ran()
    draw, runs = random.Random(1), 0
    for _ in range(KILLS):
        with lab.start(MANY) as it:
            time.sleep(draw.uniform(0.2, 0.9) * lasting)
            it.kill()
        found = results(lab)
        assert found.items() <= wanted.items(), "what is in the store is wrong"
        runs = max(runs, len(found))
        if len(found) == len(wanted):
            os.rename(lab.store, lab.folder / f"whole-{time.monotonic_ns()}")
    assert runs > 5, "no kill came while it ran"
    assert lab.script(MANY)[:2] == (0, "12\n")
    assert results(lab) == wanted
    assert not (lab.store / "now").exists()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_programs_and_says_how_to_go_on(lab, number):
    with lab.start(LONG) as it:
        wait_for(lambda: lab.stored("*.json") and len(sleeping(lab)) == 2)
        since = time.monotonic()
        it.send_signal(number)
        output, said = it.communicate(timeout=20)
    assert time.monotonic() - since < 2
    assert it.returncode == 128 + number
    assert said.splitlines()[-1:] == [
        "interrupted: what is done is kept, and the same call goes on from there"
    ]
    assert "Traceback" not in said
    assert output == "analyze stress --sleep 0 --x 0\n"
    wait_for(lambda: not sleeping(lab))
    assert sorted(path.name for path in lab.store.iterdir() if len(path.name) > 2) == [
        "rupture-store"
    ]
    assert len([line for line in lab.ran() if "stress" in line]) == 3, "what waited has begun"


def test_a_signal_ends_a_program_that_has_just_begun(lab):
    assert lab.script(AT_ONCE)[0] == 128 + signal.SIGTERM
    wait_for(lambda: not sleeping(lab))


def test_a_killed_call_takes_its_programs_with_it(lab):
    with lab.start("run('analyze stress --sleep 60')") as it:
        wait_for(lambda: sleeping(lab))
        it.kill()
    wait_for(lambda: not sleeping(lab))
    lab.call()
    assert os.listdir(lab.store / "now") == []


def test_a_second_call_is_refused_and_the_first_goes_on(lab):
    with lab.start("print(run('analyze stress --sleep 1').said)") as first:
        wait_for(lambda: (lab.folder / "ran").exists())
        code, output, said = lab.script("")
        assert code == 1 and f"another call uses {lab.store}: wait until it has ended" in said
        assert first.communicate(timeout=20) == ("analyze stress --sleep 1\n", "")


def test_a_mistake_in_a_script_ends_it_and_its_files_go(lab):
    code, _, said = lab.script("open(run('load -o a.h5')['a.h5'])\n1 / 0")
    assert code == 1 and said.endswith("ZeroDivisionError: division by zero\n")
    assert not (lab.store / "now").exists()


def test_nohup_is_respected(lab):
    text = "print(signal.getsignal(signal.SIGHUP) == signal.SIG_IGN)"
    with lab.start("import signal\n" + text) as it:
        assert it.communicate(timeout=20)[0] == "False\n"
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    assert lab.script("import signal\n" + text)[1] == "True\n"
    signal.signal(signal.SIGHUP, before)
