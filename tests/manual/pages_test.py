"""The man pages: there is one per tool, man and lexgrog find no fault, all options are in them."""

import json
import os
import re

import pytest

from conftest import BUILD, need, run

need("lexgrog")
PAGES = BUILD / "manual/man"
PLAIN = {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": "", "MAN_KEEP_FORMATTING": ""}
TOOLS = json.loads(run("rupture", "--describe").stdout)["tools"]
each_tool = pytest.mark.parametrize("tool", TOOLS, ids=lambda tool: tool["name"])


def succeeds(*command):
    done = run(*command, env=os.environ | PLAIN)
    assert done.returncode == 0, done.stderr
    return done


def text_of(name):
    page = PAGES / f"rupture-{name}.1.gz"
    return succeeds("man", "--no-hyphenation", "--no-justification", "-l", page).stdout


def words(text):
    return " ".join(text.split())


def test_there_is_one_for_each_tool_and_one_for_rupture_and_man_finds_no_fault():
    names = {f"rupture-{tool['name']}.1.gz" for tool in TOOLS} | {"rupture.1.gz"}
    assert {page.name for page in PAGES.iterdir()} == names
    for page in PAGES.iterdir():
        done = succeeds("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page)
        assert done.stderr == "", page.name


@each_tool
def test_lexgrog_finds_name_and_summary(tool):
    page = PAGES / f"rupture-{tool['name']}.1.gz"
    expected = f'{page}: "rupture-{tool["name"]} - {tool["summary"]}"\n'
    assert succeeds("lexgrog", page).stdout == expected


@each_tool
def test_all_options_and_commands_are_explained(tool):
    text = words(text_of(tool["name"]))
    assert f"SYNOPSIS rupture {tool['synopsis']} DESCRIPTION" in text
    assert not re.search(r"\[(.+)\] \[\1\]", text), "a unit stands twice"
    for command in tool.get("commands", []):
        assert command["synopsis"].removeprefix(tool["name"] + " ") in text
    for leaf in tool.get("commands") or [tool]:
        assert words(leaf["purpose"]) in text
        for option in leaf["options"]:
            assert f"--{option['name']}" in text
            assert leaf is not tool or words(option["help"]) in text


def test_parameters_have_a_page():
    assert (
        "junctions.t_R [s] mean slipping time (above 0, at most 1000; default: 0.002; laws:"
        " reference, simplified, decaying)" in words(text_of("parameters"))
    )
