"""Completion, asked for in a real bash."""

import shlex
from pathlib import Path

import pytest

from conftest import BUILD, run

SCRIPT = BUILD / "manual/rupture"

# What readline does: it splits the line at COMP_WORDBREAKS, too, and shows what COMPREPLY has.
ASK_BASH = """\
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
$(complete -p rupture | sed 's/.*-F \\([^ ]*\\) .*/\\1/')
((${#COMPREPLY[@]} == 0)) || printf '%s\\n' "${COMPREPLY[@]}"
"""

INPUTS = {"a.h5", "folder", "two words.h5"}  # in any order


@pytest.fixture(autouse=True)
def files(folder):
    others = ("b.h5.part", "my.ini", "note.txt", "folder/c.h5")
    for name in ("a.h5", "two words.h5", *others):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).touch()


def complete(line):
    words = shlex.split(line)
    done = run("bash", "--norc", "-c", ASK_BASH, "bash", SCRIPT, "rupture", *words)
    assert done.stderr == ""
    return done.stdout.splitlines()


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("pre", ["prepare"]),
        ("--v", ["--version"]),
        ("help mod", ["modify-phi"]),
        ("load --until-s", ["--until-spanned"]),
        ("restart a.h5 --until-q", ["--until-quiet"]),
        ("analyze front a.h5 --ev", ["--event"]),
        ("analyze stress --ev", []),
        ("analyze sl", ["slip", "slow-slip"]),
        ("help analyze ver", ["verify"]),
        ("load sl", []),
        ("load --set slider.N", ["slider.Nx=", "slider.Nz="]),
        ("parameters driving.", ["driving.K", "driving.h", "driving.V"]),
        ("load --set junctions.law = de", ["decaying"]),
        ("restart --set junctions.law = de", ["decaying"]),
        ("analyze steady-state --set junctions.law = de", ["decaying"]),
        ("load --set junctions.f_new =", ["zero", "f_slip"]),
        ("modify-phi --shape ''", ["uniform", "bell"]),
        ("load --until ''", []),
        ("reproduce fig2 figS6", ["figS6"]),
        ("reproduce sweep ''", ["my.ini", "folder"]),
        ("analyze front --event ''", ["first-spanning"]),
        ("reproduce --pro", ["--programs"]),
        ("restart folder/", ["folder/c.h5"]),
        ("load ''", []),
        ("restart ''", INPUTS),
        ("analyze events ''", INPUTS | {"b.h5.part"}),
        ("finish b", ["b.h5.part"]),
        ("load -o ''", INPUTS),
        ("load --config ''", {"folder", "my.ini"}),
    ],
)
def test_words_and_files_by_kind(line, expected):
    assert type(expected)(complete(line)) == expected
