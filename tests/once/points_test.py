"""Points side by side: the pool, refusals, what is known, progress, and commands that are shown."""

import os
import re
import subprocess
import threading
import time

import pytest

from conftest import succeeds
from rupture.commands import machine
from rupture.errors import Failure, MachineFailure
from rupture.once import Refused, asked, each, known, run, script_of

pytest_plugins = "laboratory"


class Meter:
    """How many are at work at a time."""

    def __init__(self):
        self.guard, self.now, self.most = threading.Lock(), 0, 0

    def work(self, seconds=0.002):
        with self.guard:
            self.now += 1
            self.most = max(self.most, self.now)
        time.sleep(seconds)
        with self.guard:
            self.now -= 1
        return 1


def test_points_within_points_use_all_cores_and_no_more(lab):
    """Each piece of work goes on only when another one is there, too."""
    meter, both = Meter(), threading.Barrier(2, timeout=60)

    def work(_):
        both.wait()
        return meter.work()

    found = each(lambda n: sum(one for _, one in each(work, range(16))), range(16))
    assert found == [((n,), 16) for n in range(16)]
    assert meter.most == 2


def test_after_a_mistake_nobody_begins_what_waits(lab):
    lab.call(cores=1)
    begun: list = []

    def point(n):
        begun.append(n)
        raise ValueError(n)

    with pytest.raises(ValueError):
        each(point, range(50))
    assert begun == [0]


def test_points_within_points_go_first_so_that_few_are_open_with_their_files(lab):
    lab.call(cores=4)
    begun: list = []
    ended: list = []

    def point(n):
        begun.append(n)
        each(lambda m: time.sleep(0.005), range(32))
        ended.append(n)
        return len(begun) - len(ended)

    assert sum(others for _, others in each(point, range(12))) <= 12 * 3  # all open: 66


def test_who_waits_for_a_command_lets_others_work(lab):
    done: list = []

    def point(n):
        if n < 3:
            run("analyze stress --sleep 0.5")
        done.append(n)

    each(point, [0, 1, 2, *range(3, 30)])
    assert {*done[:-3]} == {*range(3, 30)}, "while one works, another core is idle"
    assert lab.ran() == ["analyze stress --sleep 0.5"]


def test_many_may_wait_for_one(lab):
    assert len(each(lambda n: run("analyze stress --sleep 0.3").said, range(500))) == 500
    assert threading.active_count() < 100
    assert len(lab.ran()) == 1


def test_who_waits_for_points_helps(lab):
    lab.call(cores=1).pool.most = 0  # threads
    points = (lambda n: each(str, range(n)), range(9))
    call = threading.Thread(target=each, args=points, daemon=True)
    call.start()
    call.join(20)
    assert not call.is_alive()


@pytest.mark.parametrize(
    "megabytes, needs, programs",
    [
        (900, {}, 1),
        (3300, {}, 3),
        (3300, {"megabytes": 400}, 8),
        (99000, {}, 8),
        (99000, {"threads": 3}, 2),
    ],
)
def test_each_program_has_cores_and_memory(lab, monkeypatch, megabytes, needs, programs):
    monkeypatch.setattr(machine, "usable_cores", lambda: 8)
    monkeypatch.setattr(machine, "usable_megabytes", lambda: megabytes)
    lab.call(cores=None, **needs)
    meter = Meter()
    each(lambda n: meter.work(0.03), range(30))
    assert meter.most == programs


def test_cores_that_come_or_go_while_points_run_count(lab):
    pool, meters = lab.call(cores=1).pool, {1: Meter(), 3: Meter()}

    def point(n):
        if n in (10, 60):
            pool.resize(3 if n == 10 else 1)
            time.sleep(0.1)  # others end what they have begun
        if n < 5 or n > 65 or 20 < n < 50:
            meters[3 if 20 < n < 50 else 1].work(0.01)

    each(point, range(80))
    assert {cores: meter.most for cores, meter in meters.items()} == {1: 1, 3: 3}


# --- refusals


def refused(code=1):
    return run(f"analyze front {run(f'load --refuse {code} -o a.h5')['a.h5']}")


@pytest.mark.parametrize("code", [1, 2])
def test_a_refusal_is_a_result(lab, code):
    for _ in range(2):
        with pytest.raises(Refused, match="^load: it cannot$"):
            refused(code)
        lab.call()
    assert lab.ran() == [f"load --refuse {code} -o a.h5"]


@pytest.mark.parametrize("kind", ["crash", "full"])
def test_no_result_ends_the_call_and_the_next_one_tries_again(lab, kind):
    def point(n):
        if n == 1:
            time.sleep(0.1)
            lab.write(kind, "")
        run(f"analyze stress --x {n} --sleep {0.4 if n == 0 else 0}")
        run(f"analyze phi --x {n}")

    error = MachineFailure if kind == "full" else Failure
    with pytest.raises(error, match="'analyze stress --x 1 --sleep 0' ended with"):
        each(point, range(20))
    began = ["analyze stress --x 0 --sleep 0.4", "analyze stress --x 1 --sleep 0"]
    assert lab.ran() == began, "others still begin"
    assert len(lab.stored("*.json")) == 1, "what was going on is lost"
    os.remove(lab.folder / kind)
    assert [run(line).said for line in began] == began
    assert lab.ran() == began[1:]


# --- known points


def front(n):
    return run(f"analyze front {run(f'load --seed {n} -o a.h5')['a.h5']}").said


def test_known_points_are_those_with_all_reports_and_nothing_runs(lab):
    each(front, [1, 3])
    each(lambda n: refused(), [1])
    lab.call()
    lab.ran()

    def point(n):
        return refused() if n == 9 else [one for _, one in each(front, [n, n + 2])]

    assert known(front, range(5)) == [((1,), "analyze front a.h5"), ((3,), "analyze front a.h5")]
    found = known(point, [0, 1, 2, 9])
    assert found == [((1,), ["analyze front a.h5"] * 2)] and found.refused == [
        ((9,), "load: it cannot")
    ]
    assert known(lambda n: open(run("load --seed 1 -o a.h5")["a.h5"]).read(), [1]) == []
    assert lab.ran() == []


def test_known_points_wait_for_nobody(lab):
    def point(n):
        if n:
            time.sleep(0.1)
            since = time.monotonic()
            assert known(lambda m: run("analyze stress --sleep 0.6"), [1]) == []
            return time.monotonic() - since
        return run("analyze stress --sleep 0.6")

    assert dict(each(point, [0, 1]))[1,] < 0.3


# --- what is said


def test_progress_is_said_and_the_rest_takes_as_long_as_last_time(lab, capfd, monkeypatch):
    monkeypatch.setattr("rupture.commands.progress.PAUSE", 0.0)
    lab.call(cores=1)
    points = [(0.1, n) for n in range(4)] + [(1.5, 9)]

    def point(seconds, n, x):
        run(f"analyze stress --x {x}{n} --sleep {seconds}")

    for x in range(2):
        each(lambda seconds, n: point(seconds, n, x), points, "fronts")
    said = capfd.readouterr().err
    left = [
        int(n) for n in re.findall(r"^\[ *\d+ s, about (\d+) s left\] fronts: . of 5$", said, re.M)
    ]
    assert re.match(r"\[   2 s\] fronts: 5 of 5", said.splitlines()[-1])
    assert len(left) == 8 and max(left[:4]) <= 1 and min(left[4:]) >= 1


def test_a_dry_run_shows_commands_and_runs_none(lab, capfd):
    each(front, [1])
    lab.call(dry_run=True)
    lab.ran()
    table = lab.write("a b.csv", "")

    def point(n):
        front(n)
        made = run(
            f"restart {run('prepare -o a.h5')['a.h5']} '{table}' -o b.h5 --set 'x=1 from 2mm'"
        )["b.h5"]
        run(f"analyze phi {made}")
        run("analyze stress")

    each(point, [1, 2])
    with pytest.raises(SystemExit):
        open(run("cp x y")["y"])
    assert lab.ran() == []
    assert capfd.readouterr().out.splitlines() == [
        "rupture prepare -o a.h5",
        "rupture restart a.h5 'a b.csv' -o b.h5 --set 'x=1 from 2mm'",
        "rupture analyze phi b.h5",
        "rupture analyze stress",
        "rupture load --seed 2 -o a.h5",
        "rupture analyze front a.h5",
        "# each: 1 of 2 points wait for what a report will say",
        "cp x y",
    ]


def test_a_script_of_the_commands_gives_the_same_files(lab, monkeypatch):
    table = lab.write("tables/a b.csv", "table")
    with asked() as log:
        start = run("load -o a.h5")["a.h5"]
        after = run(f"restart {start} '{table}' -o a.h5 --set 'x=1 from 2mm'", keep=["a.h5"])[
            "a.h5"
        ]
        run(f"analyze diff {start} {after} --differ")
        with pytest.raises(Refused):
            refused()
        wanted = open(after).read()
    lab.write("bin/rupture", '#!/bin/sh\nname=$1; shift; exec "${0%/*}/$name" "$@"\n')
    monkeypatch.setenv("PATH", f"{lab.folder}/bin:{os.environ['PATH']}")
    script = lab.write("by hand/commands.sh", script_of(log, "a figure", lab.folder))
    assert str(lab.folder) not in script.read_text()
    done = subprocess.run(["bash", script.name], cwd=script.parent, capture_output=True, text=True)
    assert done.returncode and "FILES: set it to the folder that has tables/a b.csv" in done.stderr
    monkeypatch.setenv("FILES", str(lab.folder))
    succeeds("bash", script.name, cwd=script.parent)
    assert (script.parent / "002-restart/a.h5").read_text() == wanted


# --- what it costs


def test_a_command_costs_little_beyond_its_program(lab):
    def spent(*whose):
        times = os.times()
        return sum(getattr(times, name) for name in whose)

    every = ("user", "system", "children_user", "children_system")
    before = spent(*every)
    for n in range(40):
        subprocess.run(
            [lab.folder / "bin/analyze", "stress", "--x", str(n)], stdout=subprocess.DEVNULL
        )
    alone, before = spent(*every) - before, spent(*every)
    for n in range(40):
        run(f"analyze stress --x {n}")
    assert spent(*every) - before - alone < 40 * 0.02
    lab.call()
    run("analyze stress --x 0")
    before = time.process_time()
    for _ in range(10):
        for n in range(40):
            run(f"analyze stress --x {n}")
    assert time.process_time() - before < 400 * 4e-4
