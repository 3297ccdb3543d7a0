"""Real signals at random (seeded) moments of a run, among calls and between them."""

import random
import re
import signal
import subprocess
import time
from collections import namedtuple

import pytest

from conftest import BIN
from scenario import (
    INPUTS,
    Folder,
    LONG,
    case,
    check_files,
    made,
    readable_rows,
    sums,
    without_temporaries,
)

LOAD = (
    "load --config driven.ini --until 2e-3 --checkpoint-every 1e-4 --record r.h5"
    " --record-every 2e-6 --fields 3e-6 -o b.h5 --sum"
)
RESUME = LOAD + " --resume"
TIMES = 500 if LONG else 40
Whole = namedtuple("Whole", "scenario seconds rows")


@pytest.fixture(scope="module")
def whole():
    """The run that nobody disturbs."""
    scenario = made("load", LOAD, INPUTS)
    with Folder(INPUTS) as folder:
        started = time.monotonic()
        folder.must_run(LOAD)
        return Whole(scenario, time.monotonic() - started, readable_rows(folder.files(), "r.h5"))


def newest_checkpoint(files):
    return max((n for n in files if re.fullmatch(r"b-t.*\.h5", n)), default=None)


def interrupt(folder, command, number, moment):
    """Sends the command a signal after `moment` seconds; returns its end and last words."""
    process = subprocess.Popen(
        [BIN / command.split()[0], *command.split()[1:]],
        cwd=folder.path,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    time.sleep(moment)
    process.send_signal(number)
    _, words = process.communicate(timeout=120)
    return process.returncode, words


def check_end(folder, whole):
    """The run has ended as if nothing had happened."""
    files = without_temporaries(folder.files())
    wanted = sums(whole.scenario.new)
    assert {name: files.get(name) for name in wanted} == wanted
    for name in files.keys() - whole.scenario.new.keys():  # saved when interrupted
        assert re.search(r"^b-t0\.00\d{7}\.h5(\.sum)?$", name), name
    folder.must_run("analyze verify b.h5")
    folder.must_run("analyze verify r.h5")


def test_kills_leave_checkpoints_that_lead_to_the_same_end(whole):
    moments = random.Random(1)
    killed = 0
    for kill in range(TIMES):
        with case(kill), Folder(INPUTS) as folder:
            moment = moments.uniform(0.0, whole.seconds)
            code, _ = interrupt(folder, LOAD, signal.SIGKILL, moment)
            killed += code == -signal.SIGKILL
            files = folder.files()
            check_files(whole.scenario, files)
            if "r.h5.part" in files:
                rows = readable_rows(files, "r.h5.part")
                assert rows == whole.rows[: len(rows)]
            newest = newest_checkpoint(files)
            if newest is not None:
                folder.must_run(f"restart {newest} --until 2e-3 -o c.h5 -q")
                end = folder.must_run("analyze checksum c.h5").strip()
                assert end == whole.scenario.new["b.h5.sum"].decode().split()[1]
    assert killed > 0, "every run was over before its signal"


def test_kills_one_after_another_are_resumed(whole):
    moments = random.Random(2)
    for row in range(TIMES):
        with case(row), Folder(INPUTS) as folder:
            for _ in range(3):
                moment = moments.uniform(0.0, whole.seconds)
                code, words = interrupt(folder, RESUME, signal.SIGKILL, moment)
                assert code in (0, -signal.SIGKILL), words
            folder.must_run(RESUME)
            check_end(folder, whole)


def test_interruptions_are_saved_and_the_command_that_is_told_goes_on(whole):
    moments = random.Random(3)
    saved = 0
    for number in (signal.SIGINT, signal.SIGTERM) * (TIMES // 2):
        with case(number), Folder(INPUTS) as folder:
            moment = moments.uniform(0.0, whole.seconds)
            code, words = interrupt(folder, LOAD, number, moment)
            assert code in (0, -number), words
            told = re.fullmatch(r"load: [^\n]+ to continue: \S+/(load [^\n]+)\n", words)
            if code != 0 and words and "everything had been written" not in words:
                assert told, words
                if "at its first step" not in words:
                    assert newest_checkpoint(folder.files()) is not None
                    saved += 1
            folder.must_run(told[1] if told else RESUME)
            check_end(folder, whole)
    assert saved > 0, "every run was over before its signal"
