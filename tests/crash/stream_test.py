"""Standard streams that are closed or lose their reader, and a record that is moved meanwhile."""

import shlex
import signal
import subprocess

import pytest

from conftest import BIN, run, started
from scenario import INPUTS, Folder, made, sums

LOAD = (
    "load --config driven.ini --until 1e-3 --set driving.V=0.01 --record r.h5 --record-every 1e-6"
    " -o b.h5 --sum"
)


@pytest.fixture(scope="module")
def whole():
    return sums(made("alone", LOAD, INPUTS).new)


def check_files(folder, whole):
    assert sums(folder.files()) == whole
    for name in ("b.h5", "r.h5"):
        folder.must_run(f"analyze verify {name}")


FAILED = "load: cannot write to standard output\n"


@pytest.mark.parametrize(
    ("redirections", "end"),
    [
        ("| true", (128 + signal.SIGPIPE, "")),
        ("2>&-", (0, "")),
        ("<&- 2>&-", (0, "")),
        (">&-", (1, FAILED)),
        ("<&- >&- 2>&-", (1, "")),
    ],
)
def test_a_stream_that_is_closed_or_has_no_reader_costs_no_file(redirections, end, whole):
    with Folder(INPUTS) as folder:
        script = f"set -o pipefail; {shlex.quote(str(BIN))}/{LOAD} {redirections}"
        done = run("bash", "-c", script, cwd=folder.path)
        assert (done.returncode, done.stderr) == end
        check_files(folder, whole)


def test_a_record_that_is_moved_is_the_same_file_under_another_name(whole):
    tool, *options = shlex.split(LOAD)
    with Folder(INPUTS) as folder:
        command, part = [BIN / tool, *options, "-q"], folder.path / "r.h5.part"
        with started(command, part, cwd=folder.path, stderr=subprocess.PIPE) as process:
            part.rename(folder.path / "moved")
            _, said = process.communicate(timeout=120)
        assert (process.returncode, said) == (0, b"")
        check_files(folder, whole)
        assert "moved" in folder.files()
