"""What surrounds a run: the same command started twice at the same moment in one folder, of which
one gives way; standard streams that are closed or lose their reader; a record that is moved."""

import os
import re
import shlex
import shutil
import signal
import subprocess

import pytest

from conftest import BIN, run, started, stopped
from scenario import (
    FAULTS,
    INPUTS,
    LOAD,
    PREPARE,
    Folder,
    case,
    kept_in,
    made,
    sums,
    without_notes,
)

CONTAINERS = ["unshare", "--pid", "--fork"]  # both processes have the number 1
PAIRS = 10
LONGER = LOAD.replace("4e-4", "1e-3 --set driving.V=0.01")


def run_pair(command, folder, containers):
    """(exit code, last words) of both."""
    words = [*containers, BIN / command.split()[0], *command.split()[1:]]
    null, pipe = subprocess.DEVNULL, subprocess.PIPE
    both = [
        subprocess.Popen(words, cwd=folder.path, text=True, stdout=null, stderr=pipe)
        for _ in range(2)
    ]
    said = [process.communicate(timeout=120)[1] for process in both]
    return [(process.returncode, words) for process, words in zip(both, said)]


def check_files(folder, wanted):
    """Those of a run that is alone."""
    files = folder.files()
    assert sums(files) == wanted
    for name in wanted:
        folder.must_run(f"analyze verify {name}")
    return files


def check(command, options, codes, containers=()):
    """The folder ends as after one run; who fails says why in a sentence."""
    command = f"{command} {options}"
    wanted = sums(made("alone", command, INPUTS).new)
    for pair in range(PAIRS):
        with case(options, pair), Folder(INPUTS) as folder:
            ends = run_pair(command, folder, containers)
            assert sorted(code for code, _ in ends) in codes, ends
            for code, words in ends:
                sentence = r"\w+: [^\n]*(another run|exists; give --)[^\n]*\n"
                assert re.fullmatch(sentence if code else "", without_notes(words)), words
            files = check_files(folder, wanted)
            kept_in("".join(words for _, words in ends), files, files)


@pytest.mark.parametrize("containers", [[], CONTAINERS])
@pytest.mark.parametrize("command", [LOAD, PREPARE])
def test_of_two_starts_exactly_one_succeeds(command, containers):
    if run(*containers, "true").returncode:
        pytest.skip("this user cannot give processes numbers of their own")
    check(command, "", [[0, 1]], containers)


@pytest.mark.parametrize("option", ["--force", "--resume"])
def test_that_may_replace_files_leaves_those_of_one_run(option):
    check(LOAD, option, [[0, 1], [0, 0]])  # the second may begin when the first is done


@pytest.fixture(scope="module")
def whole():
    return sums(made("alone", LONGER, INPUTS).new)


@pytest.mark.parametrize(
    ("redirections", "end"),
    [
        ("| true", (128 + signal.SIGPIPE, "")),
        ("2>&-", (0, "")),
        ("<&- 2>&-", (0, "")),
        (">&-", (3, "load: cannot write to standard output\n")),
        ("<&- >&- 2>&-", (3, "")),
    ],
)
def test_a_stream_that_is_closed_or_has_no_reader_costs_no_file(redirections, end, whole):
    with Folder(INPUTS) as folder:
        script = f"set -o pipefail; {shlex.quote(str(BIN))}/{LONGER} {redirections}"
        done = run("bash", "-c", script, cwd=folder.path)
        assert (done.returncode, done.stderr) == end
        check_files(folder, whole)


@pytest.mark.parametrize("fault", ["", "inode"])
@pytest.mark.parametrize("action", ["runs", "is moved", "is moved, and a copy takes its name"])
def test_only_the_own_unfinished_record_is_removed(whole, action, fault):
    tool, *options = shlex.split(LONGER)
    with Folder(INPUTS) as folder:
        command, part = [BIN / tool, *options, "-q"], folder.path / "r.h5.part"
        moved, env = folder.path / "moved", os.environ | {"LD_PRELOAD": FAULTS, "FAULT": fault}
        with started(command, part, cwd=folder.path, env=env, stderr=subprocess.PIPE) as process:
            with stopped(process):
                if "moved" in action:
                    part.rename(moved)
                if "copy" in action:
                    shutil.copyfile(moved, part)
            _, said = process.communicate(timeout=120)
        assert (process.returncode, said) == (0, b"")
        assert (moved.exists(), part.exists()) == ("moved" in action, "copy" in action)
        if moved.exists():
            assert "ignored" not in folder.must_run("finish moved -o m.h5")  # no mark is left
            folder.must_run("analyze diff m.h5 r.h5")
            os.remove(folder.path / "m.h5")
        check_files(folder, whole)
