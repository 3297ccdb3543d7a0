"""One point of a chain, with stand-ins for the programs: what is filled in, left out and kept
(recipes/chains/point.py)."""

import json
import re
from pathlib import Path

import pytest

from chains.point import compute
from chains.store import origin_of

ANALYZE = """#!/bin/sh
case "$1" in checksum) echo 5eed; exit;; esac
echo "analyze $*" >> CALLS
case "$2" in bad) echo "analyze: first" >&2; echo "analyze: too large" >&2; exit 1;; esac
echo '{"t": [0.25, null, 2.0], "slow": null, "kind": "fast", "path": "../x"}'
"""
RESTART = """#!/bin/sh
echo "restart $*" >> CALLS
while [ "$1" != -o ]; do shift; done
touch "$2"
"""
FRONT = {"front": "analyze front r.h5"}


@pytest.fixture(name="calls")
def stand_ins(folder, monkeypatch):
    """The file with the calls of the programs."""
    for name, text in (("analyze", ANALYZE), ("restart", RESTART)):
        (folder / name).write_text(text.replace("CALLS", str(folder / "calls")))
        (folder / name).chmod(0o755)
    (folder / "in").mkdir()
    monkeypatch.setenv("RUPTURE_BIN", str(folder))
    return folder / "calls"


def work(commands, names=(), keep=(), base=None):
    return {"commands": commands, "names": dict(names), "keep": list(keep), "base": base}


WORDS = [  # those of a restart, names, and what is filled in
    ("--until {front.t[0]}", {}, "--until 0.25"),
    ("--until {front.t[2] / 4}", {}, "--until 0.5"),
    ("--for {n}", {"n": [7.0]}, "--for 7"),
    ("--x {front.kind}", {}, "--x fast"),
    ("--x {to}", {"to": "{front.slow.t or t + 1}", "t": [1]}, "--x 2"),
    ("--x {above.t[0]}", {"above": "above.json"}, "--x 4"),
]
FILLED = [  # commands after `front`, names, and what is run
    *(
        ({"a": f"restart {text} -o a.h5"}, names, [f"restart {filled} -o a.h5"])
        for text, names, filled in WORDS
    ),
    # A null: the command is left out, and so is what needs its file.
    ({"a": "restart x -o a.h5 --until {front.t[1]}"}, {}, []),
    (
        {
            "a": "restart x -o a.h5 --until {front.slow.t + 1}",
            "b": "restart a-t0.100000000.h5 -o b.h5 --for 0.01 --record r.h5 --set driving.V=0",
            "c": "analyze front b.h5",
            "d": "analyze front r.h5",
            "e": "restart x -o d.h5 --for 0.01 --set driving.V=0",
        },
        {},
        ["restart x -o d.h5 --for 0.01 --set driving.V=0"],
    ),
]


@pytest.mark.parametrize("commands, names, expected", FILLED)
def test_what_is_filled_in_and_left_out(calls, commands, names, expected):
    Path("above.json").write_text(json.dumps({"reports": {"above": {"t": [4]}}}))
    result = compute(work(FRONT | commands, names), "in")
    assert list(result["commands"].values()) == ["analyze front r.h5", *expected]
    assert (result["status"], result["sentence"]) == ("done", "")
    run = calls.read_text().splitlines()
    assert run == ["analyze front r.h5 --json", *(f"{line} --quiet" for line in expected)]
    for name in commands:
        assert name in result["commands"] or result["reports"][name] is None


ENDED = [  # commands after `front`, the sentence, and how many commands are run
    ({"b": "analyze front bad", "c": "analyze front r.h5"}, "analyze: too large", 2),
    ({"b": "restart x -o {front.path}"}, "b: .*'../x' is neither a number nor a word.*", 1),
    ({"b": "restart x -o {front.t[9]}", "c": "analyze x"}, "b: .*cannot be worked out.*", 1),
    ({"b": "restart x -o a.h5", "c": "analyze front a.h5"}, "no command has written a-t9.h5", 3),
]


@pytest.mark.parametrize("commands, sentence, count", ENDED)
def test_a_refusal_is_the_result_and_ends_the_point(calls, commands, sentence, count):
    result = compute(work(FRONT | commands, keep=["a.h5", "a-t9.h5"]), "in")
    assert result["status"] == "failed" and re.fullmatch(sentence, result["sentence"])
    assert list(result["commands"]) == ["front", *commands][:count]
    assert list(result["reports"]) == (["front", "c"] if count == 3 else ["front"])
    assert len(calls.read_text().splitlines()) == count


BASE = {"file": "above.b.h5", "shown": "b.h5", "of": "above.json"}
ABOVE = {"status": "done", "sentence": "", "checksums": {"b.h5": "1"}, "reports": {}}


def test_a_result_comes_from_the_content_of_its_base_and_from_the_programs(folder):
    def origin(*programs, **above):
        Path("above.json").write_text(json.dumps(ABOVE | above))
        return origin_of(work({"a": "restart b.h5 -o a.h5"}, base=BASE), programs)

    assert origin("1") == origin("1", reports={"other": 1})
    assert len({origin("1"), origin("2"), origin("1", checksums={"b.h5": "2"})}) == 3


def test_what_starts_from_a_file_that_was_left_out_is_left_out(calls):
    commands = {"a": "restart b-t1.h5 -o a.h5", "b": "restart a.h5 -o c.h5"}
    Path("above.json").write_text(json.dumps(ABOVE))
    Path("above.b.h5").touch()
    base = BASE | {"shown": "b-t1.h5"}
    result = compute(work(commands, keep=["a.h5"], base=base), "in")
    assert (result["status"], result["commands"]) == ("done", {})
    assert result["reports"] == {"a": None, "b": None} and not calls.exists()
