"""rupture TOOL: runs the programs, finds them, lists them, and is not in their way."""

import shutil
import signal
from pathlib import Path

import pytest

from commands import json_of, output_of, run
from conftest import BIN


@pytest.fixture(autouse=True)
def prefix(small_ini):
    """A copy of rupture in PREFIX/bin, and a folder for tools."""
    for folder in ("bin", "libexec/rupture"):
        Path(folder).mkdir(parents=True)
    shutil.copy(BIN / "rupture", "bin/rupture")


def add_tool(name, script):
    path = Path("libexec/rupture", name)
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o700)


def run_installed(*words):
    return run([Path("bin/rupture").absolute(), *words])


def test_tools_keep_their_arguments_output_and_exit_code():
    output_of("rupture load --config small.ini -o a.h5 -q")
    assert output_of("rupture analyze checksum a.h5") == output_of("analyze checksum a.h5")
    refused = run("rupture load --config small.ini -o a.h5")
    assert (refused.code, refused.err) == (1, "load: a.h5 exists; give --force to replace it\n")


def test_finds_the_tools_of_an_installed_one():
    add_tool("load", "printf '%s|' \"$@\"; exit 7")
    ran = run_installed("load", "", "two words", "--help")
    assert (ran.code, ran.out) == (7, "|two words|--help|")


def test_runs_what_stands_there_and_is_no_other_process():
    add_tool("new", "kill -TERM $$")
    assert run_installed("new").code == -signal.SIGTERM


def test_its_help_says_what_tools_say_of_themselves():
    add_tool("load", """echo '{"name": "load", "summary": "drives"}'""")
    add_tool("prepare", "echo not JSON; exit 1")
    text = run_installed("help").out
    for line in ("  load         drives", "  prepare      ", "  restart      "):
        assert f"\n{line}\n" in text


def test_lists_every_tool_with_a_summary():
    tools, text = json_of("rupture --describe")["tools"], output_of("rupture help")
    assert len(tools) >= 5
    for tool in tools:
        assert f"\n  {tool['name']} " in text and tool["summary"] in text
        assert tool == json_of(f"{tool['name']} --describe")
    assert output_of("rupture --help") == output_of("rupture help help") == text


def test_help_of_a_tool_is_its_own():
    assert output_of("rupture help load") == output_of("load --help")
    assert output_of("rupture help analyze front") == output_of("analyze front --help")


def test_says_where_it_misses_the_programs_if_it_was_copied():
    Path("libexec/rupture/restart").write_text("not executable")
    for folder in ("libexec/rupture", "bin"):
        copied = run_installed("restart")
        sentence = (
            f"rupture: there is no program restart in {Path(folder).resolve()}: install rupture, or"
            " link to it instead of copying it\n"
        )
        assert (copied.code, copied.err) == (1, sentence)
        shutil.rmtree("libexec", ignore_errors=True)


def test_shows_its_help_where_no_tool_is_given():
    alone = run("rupture")
    assert (alone.code, alone.out, alone.err) == (2, "", output_of("rupture help"))
