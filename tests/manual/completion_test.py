"""Completion, asked for in a real bash, and in zsh where it is installed."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from conftest import BUILD

SCRIPT = BUILD / "manual/rupture"
FILES = ("a.h5", "b.h5.part", "my.ini", "note.txt", "folder/c.h5", "two words.h5")

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


class Completion(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in FILES:
            (self.folder / name).parent.mkdir(exist_ok=True)
            (self.folder / name).touch()

    def complete(self, *words):
        result = subprocess.run(
            ["bash", "--norc", "-c", ASK_BASH, "bash", SCRIPT, "rupture", *words],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.stderr, "")
        return result.stdout.splitlines()


class Bash(Completion):
    def test_tools(self):
        self.assertEqual(self.complete("pre"), ["prepare"])
        self.assertEqual(self.complete("--v"), ["--version"])
        self.assertLessEqual({"load", "analyze", "help"}, set(self.complete("")))
        self.assertEqual(self.complete("help", "mod"), ["modify-phi"])

    def test_options_are_those_of_the_tool_or_command(self):
        self.assertEqual(self.complete("load", "--unt"), ["--until"])
        self.assertEqual(self.complete("restart", "a.h5", "--until-"), ["--until-quiet"])
        self.assertEqual(self.complete("analyze", "front", "a.h5", "--ev"), ["--event"])
        self.assertEqual(self.complete("analyze", "stress", "--ev"), [])

    def test_every_option_of_every_command(self):
        asked = subprocess.run(
            [BUILD / "bin/rupture", "--describe"], capture_output=True, check=True
        )
        for tool in json.loads(asked.stdout)["tools"]:
            for leaf in tool.get("commands") or [tool]:
                options = [f"--{option['name']}" for option in leaf.get("options", [])]
                self.assertEqual(self.complete(*leaf["name"].split(), "--"), options)

    def test_commands_of_analyze(self):
        self.assertEqual(self.complete("analyze", "sl"), ["slip", "slow-slip"])
        self.assertEqual(self.complete("help", "analyze", "ver"), ["verify"])
        self.assertEqual(self.complete("load", "sl"), [])

    def test_parameters(self):
        self.assertEqual(self.complete("load", "--set", "slider.N"), ["slider.Nx=", "slider.Nz="])
        self.assertEqual(self.complete("parameters", "driving."), [f"driving.{n}" for n in "KhV"])
        for words in ("load", "restart"), ("analyze", "steady-state"):
            given = self.complete(*words, "--set", "junctions.law", "=", "de")
            self.assertEqual(given, ["decaying"])
        self.assertEqual(len(self.complete("load", "--set", "junctions.f_new", "=")), 2)

    def test_words_of_a_choice(self):
        self.assertEqual(self.complete("modify-phi", "--shape", ""), ["uniform", "bell"])
        self.assertEqual(self.complete("load", "--until", ""), [])

    def test_recipes_and_commands_of_reproduce(self):
        listed = subprocess.run(
            [BUILD / "bin/rupture", "reproduce", "list"], capture_output=True, check=True, text=True
        )
        words = {line.split()[0] for line in listed.stdout.splitlines()}
        self.assertLessEqual({"fig3", "choices", "all", "sweep"}, words)
        self.assertEqual(set(self.complete("reproduce", "")), words)
        self.assertEqual(self.complete("reproduce", "fig2", "figS6"), ["figS6"])
        self.assertEqual(self.complete("reproduce", "sweep", "my"), ["my.ini"])
        self.assertEqual(self.complete("reproduce", "--pro"), ["--profile", "--programs"])

    def test_files_by_kind(self):
        inputs = ["a.h5", "folder", "two words.h5"]
        self.assertEqual(sorted(self.complete("restart", "")), inputs)
        self.assertEqual(sorted(self.complete("analyze", "events", "")), inputs)
        self.assertEqual(self.complete("restart", "folder/"), ["folder/c.h5"])
        self.assertEqual(sorted(self.complete("load", "--config", "")), ["folder", "my.ini"])
        self.assertEqual(sorted(self.complete("load", "-o", "")), inputs)
        self.assertEqual(self.complete("load", ""), [])


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class Zsh(Completion):
    def shown(self, line):
        result = subprocess.run(
            ["zsh", "-f", "-c", ASK_ZSH, "zsh", SCRIPT.parent, self.folder, line],
            env=os.environ | {"TERM": "dumb", "HOME": str(self.folder)},
            capture_output=True,
            text=True,
            check=False,
        )
        return result.stdout

    def test_tools_options_parameters_and_files(self):
        for line, expected in (
            ("prep", "prepare"),
            ("load --unt", "--until"),
            ("analyze front --rupt", "--ruptured-below"),
            ("load --set junctions.la", "junctions.law="),
            ("load --set junctions.law=dec", "decaying"),
            ("load --config m", "my.ini"),
            ("restart tw", "two\\ words.h5"),
            ("reproduce converg", "convergence"),
            ("reproduce sweep m", "my.ini"),
        ):
            self.assertIn(expected, self.shown(line), line)
