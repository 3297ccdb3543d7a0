"""analyze lineage: scripts for odd names and changed chains; see tables/lineage.txt."""

import json
import os
from pathlib import Path

import pytest

import rupture
from changes import change
from commands import checksum_of, expect_rebuilt, lines_of
from commands import output_of, run_script, script_for

pytestmark = pytest.mark.usefixtures("small_ini")


def put(name, entry, field, text):
    change(name, f"resealed put /provenance/{entry:04}/{field} {json.dumps(text)}")


def test_paths_with_spaces_and_quotes():
    Path("it's a folder").mkdir()
    start, end = "it's a folder/$HOME.h5", "\"end\" of 'it'\n.h5"
    output_of(["load", "--config", "small.ini", "-o", start, "--until", "1e-4"])
    output_of(["restart", start, "-o", end, "--for", "1e-5"])
    expect_rebuilt(end)
    script = script_for(end, "--from", str(Path(start).absolute()), "-o", "a 'new' $name.h5")
    done = run_script(script)
    assert done.code == 0, done.err
    assert checksum_of("again/a 'new' $name.h5") == checksum_of(end), script


def test_paths_that_are_no_utf8():
    name = os.fsdecode(b"\xff.h5")
    output_of(["load", "--config", "small.ini", "-o", name])
    expect_rebuilt(name)
    assert rupture.open(name).provenance[0]["command_line"].endswith(" -o '\ufffd.h5'")
    change(name, r'content put /provenance/0000/command_line "\udcff"')  # as earlier builds wrote
    assert rupture.open(name).provenance[0]["command_line"] == "\ufffd"
    said = json.loads(output_of(["analyze", "show", name, "--json"]))
    assert said["checksum"] == checksum_of(name)


@pytest.fixture
def two_steps():
    """a.h5 and b.h5, which began with it."""
    output_of("load --config small.ini -o a.h5 --until 1e-4")
    output_of("restart a.h5 -o b.h5 --for 1e-5")


def test_the_script_checks_every_file(two_steps):
    good = script_for("b.h5")
    for file in ("step-0000.h5", "rebuilt.h5"):
        start, end = good.split(f"check {file} ")
        done = run_script(f"{start}check {file} {'1' if end[0] == '0' else '0'}{end[1:]}")
        assert done.code == 1
        assert f"{file} has another content checksum than" in done.err


def test_no_control_characters_are_printed():
    output_of("load --config small.ini -o a.h5")
    lines = len(lines_of(output_of("analyze show a.h5")))
    for field in ("tool", "version", "commit", "command_line", "compiler", "rebuild"):
        put("a.h5", 0, field, "\x1b[2J\n\x9bX")
    assert len(lines_of(output_of("analyze show a.h5"))) == lines
    for command in ("analyze show a.h5", "analyze lineage a.h5"):
        assert not set(output_of(command)) & set("\x1b\x9b\udc9b"), command


def test_comments_of_the_script_hold_no_commands():
    output_of("load --config small.ini -o a.h5")
    for field in ("command_line", "version", "compiler"):
        put("a.h5", 0, field, "x\nexit 7")
    assert "\nexit 7" not in script_for("a.h5")
