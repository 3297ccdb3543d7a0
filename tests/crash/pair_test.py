"""The same command started twice at the same moment, in one folder: one of the two gives way."""

import re
import subprocess

import pytest

from conftest import BIN
from scenario import INPUTS, Folder, LONG, case, kept_in, made, sums, without_notes

LOAD = (
    "load --config driven.ini --until 4e-4 --checkpoint-every 1.5e-4 --record r.h5"
    " --record-every 6e-7 -o b.h5 --sum"
)
PREPARE = "prepare --config rest.ini --tau-bar 0.5 -o b.h5 --sum"
CONTAINERS = ["unshare", "--pid", "--fork"]  # both processes have the number 1
PAIRS = 120 if LONG else 20


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


def check(command, options, codes, containers=()):
    """The folder ends as after one run; who fails says why in a sentence."""
    wanted = sums(made("alone", command, INPUTS).new)
    for pair in range(PAIRS):
        with case(options, pair), Folder(INPUTS) as folder:
            ends = run_pair(f"{command} {options}", folder, containers)
            assert sorted(code for code, _ in ends) in codes, ends
            for code, words in ends:
                sentence = r"\w+: [^\n]*(another run|exists; give --)[^\n]*\n"
                assert re.fullmatch(sentence if code else "", without_notes(words)), words
            files = folder.files()
            assert sums(files) == wanted
            for name in wanted:
                folder.must_run(f"analyze verify {name.removesuffix('.sum')}")
            kept_in("".join(words for _, words in ends), files, files)


@pytest.mark.parametrize("command", [LOAD, PREPARE])
def test_of_two_starts_exactly_one_succeeds(command):
    check(command, "", [[0, 1]])


@pytest.mark.parametrize("command", [LOAD, PREPARE])
def test_of_two_starts_in_containers_exactly_one_succeeds(command):
    if subprocess.run([*CONTAINERS, "true"], capture_output=True, check=False).returncode:
        pytest.skip("this user cannot give processes numbers of their own")
    check(command, "", [[0, 1]], CONTAINERS)


@pytest.mark.parametrize("option", ["--force", "--resume"])
def test_that_may_replace_files_leaves_those_of_one_run(option):
    check(LOAD, option, [[0, 1], [0, 0]])  # the second may begin when the first is done
