"""Real signals at random (seeded) moments of a run, among calls and between them."""

import functools
import itertools
import random
import re
import shlex
import signal
import subprocess
import time

from conftest import BIN, skip
from rupture.replacing import ENDING
from scenario import INPUTS, LONG, Folder, case, made
from scenario import run, sums, without_notes, without_temporaries

LOAD = (
    "load --config driven.ini --until 2e-3 --checkpoint-every 1e-4 --record-every 2e-6"
    " --fields 3e-6"
)
NAMES = ("b.h5", "x --resume.h5", "a -- b.h5", "restart --until 1.h5", "it's.h5")
TIMES = 500 if LONG else 15


def load(name, *more):
    """A run whose files have this name."""
    return shlex.join([*LOAD.split(), "-o", name, "--record", f"r {name}", *more])


@functools.cache
def whole(name):
    """The files of the run that nobody disturbs, and how long it takes [s]."""
    new = made("load", load(name), INPUTS).new
    with Folder(INPUTS) as folder:
        started = time.monotonic()
        folder.must_run(load(name))
        return new, time.monotonic() - started


def interrupt(folder, name, number, moments, *more):
    """Sends the run a signal at one of the moments; returns its end and last words."""
    tool, *options = shlex.split(load(name, *more))
    quiet: dict = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
    process = subprocess.Popen([BIN / tool, *options], cwd=folder.path, **quiet)
    time.sleep(moments.uniform(0.0, whole(name)[1]))
    process.send_signal(number)
    _, words = process.communicate(timeout=120)
    return process.returncode, words


def check_end(folder, name):
    """The run has ended as if nothing had happened."""
    files = without_temporaries(folder.files())
    new, _ = whole(name)
    assert sums(files).items() >= sums(new).items()
    saved = re.compile(re.escape(name.removesuffix(".h5")) + r"-t0\.00\d{7}\.h5")
    for other in files.keys() - new.keys():  # saved when interrupted
        assert saved.fullmatch(other), other
    folder.must_run(shlex.join(["analyze", "verify", name]))
    folder.must_run(shlex.join(["analyze", "verify", f"r {name}"]))


def test_kills_one_after_another_are_resumed():
    moments = random.Random(2)
    codes = set()
    for row in range(TIMES):
        with case(row), Folder(INPUTS) as folder:
            for _ in range(3):
                code, words = interrupt(folder, "b.h5", signal.SIGKILL, moments, "--resume")
                assert code in (0, -signal.SIGKILL), words
                codes.add(code)
            folder.must_run(load("b.h5", "--resume"))
            check_end(folder, "b.h5")
    assert -signal.SIGKILL in codes, "every run was over before its signal"


def check_resumed(folder, name, words):
    """The command that is told goes on; whether it began from a checkpoint that was saved."""
    told = re.fullmatch(r"load: ([^\n]+) to continue: (\S+/load [^\n]+)\n", words)
    assert told, words
    tool, *options = shlex.split(load(name))
    assert shlex.split(told[2]) == [str(BIN / tool), "--resume", *options]
    saved = re.search("saved as (.+); *$", told[1])
    assert saved or "at its first step" in words, words
    resumed = run(told[2], folder.path)
    assert (resumed.returncode, without_notes(resumed.stderr)) == (0, "")
    assert not saved or f"resuming from {saved[1]}\n" in resumed.stdout
    return bool(saved)


def test_interruptions_are_saved_and_the_command_that_is_told_goes_on():
    """Also where the names of files are words of a command."""
    moments = random.Random(3)
    saved: set = set()
    numbers = itertools.cycle((signal.SIGINT, *ENDING))
    for attempt, name, number in zip(range(10 * TIMES), itertools.cycle(NAMES), numbers):
        if attempt >= TIMES and saved == {*NAMES}:
            break
        with case(number, name), Folder(INPUTS) as folder:
            code, words = interrupt(folder, name, number, moments)
            assert code in (0, -number), words
            if code and words and "everything had been written" not in words:
                if check_resumed(folder, name, words):
                    saved.add(name)
            assert code or not words
            folder.must_run(load(name, "--resume"))
            check_end(folder, name)
            complete = folder.must_run(load(name, "--resume"))
            assert complete == f"{name} is complete\n"
    assert saved == {*NAMES}, "every run was over before its signal"


def test_process_number_1_is_saved_and_ends_when_its_time_is_up():
    """As in a container. The kernel repeats this signal every second."""
    program = f"unshare --pid --fork {BIN}/load --config driven.ini --until 9 -o b.h5 -q"
    with Folder(INPUTS) as folder:
        outcome = run(f"bash -c 'ulimit -S -t 1; {program}'", folder.path)
    if outcome.stderr.startswith("unshare: "):
        skip("This user cannot give processes numbers of their own.")
    assert outcome.returncode == 128 + signal.SIGXCPU and "saved as b-t" in outcome.stderr
