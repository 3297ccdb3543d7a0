"""An interrupted run is saved, and the command that it tells goes on from there, also where the
names of files are words of a command."""

import itertools
import re
import shlex
import signal
import subprocess

import pytest

from conftest import BIN, skip, started
from rupture.replacing import ENDING
from scenario import INPUTS, Folder, run, without_notes

LOAD = "load --config driven.ini --until 0.1 --record-every 2e-6"
NAMES = ("b.h5", "x --resume.h5", "a -- b.h5", "restart --until 1.h5", "it's.h5")


@pytest.fixture(scope="module")
def checksum():
    """Of the run that nobody disturbs."""
    with Folder(INPUTS) as folder:
        folder.must_run(f"{LOAD} -o b.h5 --record r.h5 -q")
        return folder.must_run("analyze checksum b.h5")


@pytest.mark.parametrize("name, number", zip(NAMES, itertools.cycle((signal.SIGINT, *ENDING))))
def test_it_is_saved_and_goes_on(name, number, checksum):
    words = [*LOAD.split(), "-o", name, "--record", f"r {name}"]
    with Folder(INPUTS) as folder:
        quiet: dict = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
        quiet["preexec_fn"] = lambda: signal.signal(number, signal.SIG_DFL)  # nohup ignores some
        command, part = [BIN / words[0], *words[1:]], folder.path / f"r {name}.part"
        process = started(command, part, 2, cwd=folder.path, **quiet)
        process.send_signal(number)
        _, said = process.communicate(timeout=120)
        assert process.returncode == -number
        found = re.fullmatch(r"load: .* saved as (.+); +to continue: (\S+/load .+)\n", said)
        assert found, said
        saved, told = found.groups()
        assert shlex.split(told) == [str(BIN / "load"), "--resume", *words[1:]]
        resumed = run(told, folder.path)
        assert (resumed.returncode, without_notes(resumed.stderr)) == (0, "")
        assert f"resuming from {saved}\n" in resumed.stdout
        assert folder.must_run(shlex.join(["analyze", "checksum", name])) == checksum
        assert folder.must_run(shlex.join([*words, "--resume"])) == f"{name} is complete\n"


def test_process_number_1_is_saved_and_ends_when_its_time_is_up():
    """As in a container. The kernel repeats this signal every second."""
    program = f"unshare --pid --fork {BIN}/load --config driven.ini --until 9 -o b.h5 -q"
    with Folder(INPUTS) as folder:
        outcome = run(f"bash -c 'ulimit -S -t 1; {program}'", folder.path)
    if outcome.stderr.startswith("unshare: "):
        skip("This user cannot give processes numbers of their own.")
    assert outcome.returncode == 128 + signal.SIGXCPU and "saved as b-t" in outcome.stderr
