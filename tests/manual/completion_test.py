"""Completion, asked for in a real bash, and in zsh where it is installed."""

import json
import os
import shlex
import shutil
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

# zsh completes in a terminal only, so it gets one of its own. Ctrl-X prints the completed line.
ASK_ZSH = """\
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PROMPT= ; fpath=(${(q)1} \\$fpath); autoload -U compinit; compinit -u -D"
zpty -w shell 'bindkey "^I" complete-word "^X" show'
zpty -w shell 'show() { print -r -- "<$BUFFER>" }; zle -N show'
zpty -w shell "cd ${(q)2}; echo rea''dy"
zpty -r -m shell out '*ready*'
zpty -w -n shell "rupture $3"$'\\t\\C-x'
zpty -r -m shell out '*<rupture*>*'
print -r -- $out
"""

INPUTS = {"a.h5", "folder", "two words.h5"}  # in any order


@pytest.fixture(autouse=True)
def files(folder):
    others = ("a.h5.sum", "b.h5.part", "my.ini", "note.txt", "folder/c.h5")
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
        ("load --unt", ["--until"]),
        ("restart a.h5 --until-", ["--until-quiet"]),
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
        ("golden ''", ["check", "regenerate"]),
        ("golden check no", ["note.txt"]),
        ("golden check golden.sums no", ["note.txt"]),
        ("reproduce --pro", ["--profile", "--programs"]),
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


def test_every_program_and_every_option_of_every_command():
    assert {"load", "analyze", "help"} <= set(complete("''"))
    for tool in json.loads(run("rupture", "--describe").stdout)["tools"]:
        for leaf in tool.get("commands") or [tool]:
            options = [f"--{option['name']}" for option in leaf.get("options", [])]
            assert complete(f"{leaf['name']} --") == options


def test_recipes_and_commands_of_reproduce():
    words = {line.split()[0] for line in run("rupture", "reproduce", "list").stdout.splitlines()}
    assert {"fig3", "choices", "all", "sweep"} <= words
    assert set(complete("reproduce ''")) == words


@pytest.mark.skipif(not shutil.which("zsh"), reason="zsh is not installed")
@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("prep", "prepare"),
        ("load --unt", "--until"),
        ("analyze front --rupt", "--ruptured-below"),
        ("help analyze ver", "verify"),
        ("load --set junctions.la", "junctions.law="),
        ("load --set junctions.law=dec", "decaying"),
        ("load --config m", "my.ini"),
        ("restart tw", "two\\ words.h5"),
        ("reproduce converg", "convergence"),
        ("reproduce sweep m", "my.ini"),
    ],
)
def test_zsh(line, expected, folder):
    env = os.environ | {"TERM": "dumb", "HOME": str(folder)}
    done = run("zsh", "-f", "-c", ASK_ZSH, "zsh", SCRIPT.parent, folder, line, env=env)
    assert expected in done.stdout
