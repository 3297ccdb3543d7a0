"""A second call of ./reproduce.sh: what is current is not computed again, whatever is stale is."""

import hashlib
import json
import re
import shutil

import pytest

from runs.written import append_to
from stand_ins import Project

TINY = """\
rule tiny_report:
    output: f"{DATA}/tiny.json"
    message: "tiny: report"
    shell: "echo 1 > {output}"

figure("tiny", events=["fast-only"], reads=["fast-only.h5", "tiny.json"])
"""
FIGURE = """\
def make(data, results):
    for ending in ("png", "pdf"):
        (results / f"tiny.{ending}").write_text(ending)
    return []
"""
DRAW, VERIFY = "tiny: draw, and judge the claims", "fast-only: verify the shipped checkpoint"
CRATE = "results/ro-crate-metadata.json"


class Tiny(Project):
    """With a recipe that starts from a shipped checkpoint, and stand-ins for cmake and analyze."""

    def __init__(self, root):
        super().__init__(root)
        for rules in root.glob("recipes/*/rules.smk"):
            shutil.rmtree(rules.parent)
        self.write("recipes/tiny/rules.smk", TINY)
        self.write("recipes/tiny/figure.py", FIGURE)
        self.write("src/load.cpp", "// 1\n")
        self.program("cmake", "")
        self.program("load", "")
        for name in ("analyze", "../build/release/bin/analyze"):
            self.program(name, "sha256sum < $2 | cut -d' ' -f1")
        self.ship("a checkpoint")

    def ship(self, content):
        self.write("checkpoints/fast-only.h5", content)
        checksum = hashlib.sha256(content.encode()).hexdigest()
        self.write("checkpoints/manifest", f"content-sha256 {checksum}  fast-only.h5\n")

    def delete(self, name):
        (self.root / name).unlink()

    def steps(self, *options):
        """That a call takes. It says so if there are none."""
        done = self.call("tiny", *options)
        assert done.returncode == 0, done.stderr + done.stdout
        steps = re.findall(r"^\[.*\] \d+/\d+ (.*)", done.stdout, re.MULTILINE)
        assert ("Nothing to compute" in done.stdout) == (not steps), done.stdout
        return steps


@pytest.fixture(name="tiny")
def tiny_project(tmp_path):
    return Tiny(tmp_path)


def test_what_was_run_is_noted_for_the_report(tiny):
    tiny.steps()
    last = json.loads((tiny.root / "results/jobs.jsonl").read_text().splitlines()[-1])
    assert (last["rule"], last["output"][0]) == ("tiny", "results/tiny/claims.json")
    assert "recipes/tiny/figure.py" in last["command"]
    crate = json.loads((tiny.root / CRATE).read_text())
    [run] = [each for each in crate["@graph"] if each["@id"] == "#run-tiny"]
    assert run["startTime"] <= run["endTime"]


def test_what_describes_the_results_is_written_again_when_that_may_differ(tiny):
    def written():
        tiny.steps()
        return (tiny.root / CRATE).stat().st_mtime_ns

    first = written()
    assert written() == first
    tiny.append("recipes/tiny/README.md")
    second = written()
    assert second > first
    tiny.delete("results/tiny/claims.json")
    assert written() > second


def test_is_said_and_whatever_is_stale_is_found(tiny):
    assert len(tiny.steps()) == 4
    assert tiny.steps() == []
    rules = TINY.replace("echo 1", "echo 2")
    for change, words, last_step in (
        (tiny.append, ["src/load.cpp"], VERIFY),
        (tiny.append, ["src/load.cpp"], DRAW),  # a figure may run programs
        (tiny.append, ["recipes/tiny/figure.py"], DRAW),
        (tiny.append, ["recipes/common/claims/claim.py"], DRAW),
        (tiny.write, ["recipes/tiny/rules.smk", rules], DRAW),
        (tiny.ship, ["another checkpoint"], DRAW),
        (tiny.delete, ["results/tiny/claims.json"], DRAW),
        (tiny.delete, ["results/data/fast-only.h5"], VERIFY),  # behind a result
        (tiny.append, ["results/data/fast-only.h5.sum"], DRAW),  # edited
    ):
        change(*words)
        assert last_step in tiny.steps(), words
    assert tiny.steps() == []


def test_other_programs_count_by_their_bytes(tiny):
    options = ("--programs", "bin")
    tiny.steps(*options)
    assert tiny.steps(*options) == []
    tiny.append("bin/load")
    assert VERIFY in tiny.steps(*options)


def test_a_link_in_the_place_of_what_is_noted_is_refused_and_not_followed(tiny):
    theirs = tiny.write("theirs", "theirs")
    link = tiny.write("results/jobs.json").with_suffix(".jsonl")
    link.symlink_to(theirs)
    done = tiny.call("tiny")
    assert (done.returncode, theirs.read_text()) == (1, "theirs")
    assert done.stderr.startswith("reproduce.sh: results/jobs.jsonl is a link, which is not")
    with pytest.raises(OSError):
        append_to(link)
