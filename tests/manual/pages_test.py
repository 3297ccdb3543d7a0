"""The man pages: there is one per tool and command, man and lexgrog find no fault, all options are
in them, and their examples run."""

import json
import os
import re

import pytest

from conftest import BIN, BUILD, ROOT, need, need_modules, run

need("lexgrog")
PAGES = BUILD / "manual/man"
PLAIN = {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": "", "MAN_KEEP_FORMATTING": ""}
TOOLS = json.loads(run("rupture", "--describe").stdout)["tools"]
ALL = TOOLS + [command for tool in TOOLS for command in tool.get("commands", [])]
SCRIPT = ROOT / "src/tools/manual/examples.sh"
each_tool = pytest.mark.parametrize("tool", ALL, ids=lambda tool: tool["name"])


def succeeds(*command):
    done = run(*command, env=os.environ | PLAIN)
    assert done.returncode == 0, done.stderr
    return done


def text_of(name):
    page = PAGES / f"rupture-{name.replace(' ', '-')}.1.gz"
    return succeeds("man", "--no-hyphenation", "--no-justification", "-l", page).stdout


def words(text):
    return " ".join(text.split())


def test_there_is_one_for_each_tool_and_one_for_rupture_and_man_finds_no_fault():
    names = {f"rupture-{tool['name']}.1.gz".replace(" ", "-") for tool in ALL} | {"rupture.1.gz"}
    assert {page.name for page in PAGES.iterdir()} == names
    for page in PAGES.iterdir():
        done = succeeds("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page)
        assert done.stderr == "", page.name


@each_tool
def test_lexgrog_finds_name_and_summary(tool):
    name = f"rupture-{tool['name']}".replace(" ", "-")
    expected = f'{PAGES}/{name}.1.gz: "{name} - {tool["summary"]}"\n'
    assert succeeds("lexgrog", PAGES / f"{name}.1.gz").stdout == expected


@each_tool
def test_all_options_and_commands_are_explained(tool):
    text = words(text_of(tool["name"]))
    assert f"SYNOPSIS rupture {tool['synopsis']} DESCRIPTION" in text
    assert not re.search(r"\[(.+)\] \[\1\]", text), "a unit stands twice"
    assert words(tool["purpose"]) in text
    for command in tool.get("commands", []):
        assert f"rupture-{command['name'].replace(' ', '-')}(1) {command['summary']}" in text
    for option in tool.get("options", []):
        assert f"--{option['name']}" in text and words(option["help"]) in text
    assert f"EXAMPLES rupture {tool['name']}" in text
    others = [f"rupture-{other['name']}(1)," for other in TOOLS if other is not tool]
    assert f"SEE ALSO {' '.join(others)} rupture(1)" in text


def test_the_examples_run(folder):
    need_modules("h5py", "matplotlib")
    path = f"{BIN}:{os.environ['PATH']}"
    done = run("bash", "-ex", SCRIPT, env=os.environ | {"PATH": path})
    assert done.returncode == 0, done.stderr


def test_parameters_have_a_page():
    assert (
        "junctions.t_R [s] mean slipping time (above 0, at most 1000; default: 0.002; laws:"
        " reference, simplified, decaying)" in words(text_of("parameters"))
    )
