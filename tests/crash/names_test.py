"""A run whose files are named like words of a command is interrupted, and resumed as it says."""

import re
import shlex
import signal
import subprocess
import time

import pytest

from conftest import BIN, run
from scenario import INPUTS, Folder, without_notes

NAMES = ("x --resume.h5", "a -- b.h5", "restart --until 1.h5", "it's.h5")
SECONDS = 60  # until the first checkpoint must be there
# A run that takes some seconds and leaves its first checkpoint early.
LOAD = f"{BIN}/load --config driven.ini --until 0.4 --checkpoint-every 2e-3 --set driving.V=0.01"


def command(name, *more):
    return [*LOAD.split(), "-o", name, "--record", f"of {name}", "--record-every", "1e-3", *more]


def interrupt(words, folder):
    """Sends SIGINT once there is a checkpoint; returns what the program said at its end."""
    pipe = subprocess.PIPE
    process = subprocess.Popen(words, cwd=folder.path, stdout=pipe, stderr=pipe, text=True)
    until = time.monotonic() + SECONDS
    while not any(re.search(r"-t0\.\d{9}\.h5$", name) for name in folder.files()):
        assert time.monotonic() < until, "no checkpoint came"
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert process.returncode == -signal.SIGINT, out + err
    return out, err


@pytest.fixture(scope="module")
def whole():
    """The checksum of the run that nobody interrupts."""
    with Folder(INPUTS) as folder:
        assert run(*command("whole.h5"), cwd=folder.path).returncode == 0
        return folder.must_run("analyze checksum whole.h5")


@pytest.mark.parametrize("name", NAMES)
def test_the_command_that_is_told_goes_on_and_the_run_is_complete(name, whole):
    with Folder(INPUTS) as folder:
        out, err = interrupt(command(name), folder)
        told = re.fullmatch(
            r"load: interrupted, and saved as (.+\.h5); to continue: (.+)\n", without_notes(err)
        )
        assert told, err
        assert told[1] in folder.files()
        assert "wrote " in out
        tool, *options = command(name)
        assert shlex.split(told[2]) == [tool, "--resume", *options]
        resumed = run(*shlex.split(told[2]), cwd=folder.path)
        assert (resumed.returncode, without_notes(resumed.stderr)) == (0, "")
        assert f"resuming from {told[1]}\n" in resumed.stdout
        again = run(*command(name, "--resume"), cwd=folder.path)
        assert again.stdout == f"{name} is complete\n"
        assert run("analyze", "checksum", name, cwd=folder.path).stdout == whole
