"""What a figure alone says of its claims, and the verdicts of the release beside it."""

import json
from dataclasses import asdict, replace

import pytest

from claims.claim import Claim, Share, write_claims
from claims.print_claims import print_claims
from claims.released import released
from fixture import spill


def claim(name, *judged):
    """With these values of what is shown, shares, verdict and reason."""
    return Claim(name, "finding", "today", "what the paper says", "if it is so", {}, *judged)


SHARE = Share("primary", 3, 20, 20, 0.06, 0.31)
CLAIMS = [
    claim("3A", "holds", [], None, "no sample has been computed yet"),
    claim("3B", "does not hold", [], None, "no sample has been computed yet"),
    claim("4C", "holds", [SHARE], "in part", "holds in 3 of 20 runs (primary)"),
]
TABLE = """id,kind,fixed,verdict,holds,samples,version,numbers
3A,finding,today,reproduced,86,91,0.4.0,{}
3C-inset,finding,today,depends,1,1,0.4.0,{}
choices,,,,,,0.4.0,{}
"""
BUILD = "rupture 0.4.0, commit 616c08cac6ea, gcc 12"
TEXT = """
fig3: 1 in part; for what is shown, without a verdict, 1 of 2 claims holds

claim of the paper
      shown           verdict         share               least  measured by
----------------------------------------------------------------------------------------------------
3A: what the paper says
      holds           -
      no sample has been computed yet; released verdict: 0.4.0: reproduced, 86 of 91
3B: what the paper says
      does not hold   -
      no sample has been computed yet
4C: what the paper says
      holds           in part         0.15 (0.06-0.31)    0.15   primary
      holds in 3 of 20 runs (primary)
Pictures and data: {folder}/
A verdict needs runs with other random numbers: {command} makes them once, which takes long.
"""


@pytest.mark.parametrize(
    "builds, known",
    [
        ([BUILD], True),
        ([], True),  # nothing was computed: a closed form
        ([BUILD, BUILD.replace("0.4.0", "0.4.1")], False),
        ([BUILD.replace("ea,", "ea-dirty,")], False),
        (["unknown (no provenance)"], False),
    ],
)
def test_verdicts_of_the_release_are_of_its_programs(tmp_path, builds, known):
    spill(tmp_path / "docs/verdicts.csv", TABLE)
    texts = {"3A": "0.4.0: reproduced, 86 of 91", "3C-inset": "0.4.0: depends"}
    assert released(tmp_path, [(build, 1) for build in builds]) == (texts if known else {})
    assert released(tmp_path / "elsewhere", []) == {}


@pytest.mark.parametrize(
    "name, advice",
    [
        ("fig3", "./reproduce.sh ensemble fig3"),
        ("other/fig1", "./reproduce.sh other/runs other/fig1"),
    ]
    + [("alone/fig1", "")],
)
def test_advice_for_a_verdict_names_recipes_of_the_same_paper(
    tmp_path, capsys, monkeypatch, name, advice
):
    papers = {"": {"samples": "ensemble"}, "other": {"samples": "runs"}, "alone": {}}
    monkeypatch.setattr("claims.table.read", lambda paper: (papers[paper], {}))
    (tmp_path / name).mkdir(parents=True)
    write_claims(tmp_path / name / "claims.json", CLAIMS)
    print_claims(name, tmp_path, tmp_path)
    said = capsys.readouterr().out
    assert (f"{advice} makes them once" if advice else "") in said
    assert ("A verdict needs" in said) == bool(advice)


def test_what_is_shown_is_no_verdict(tmp_path, capsys):
    folder = tmp_path / "fig3"
    folder.mkdir()
    write_claims(folder / "claims.json", CLAIMS, builds=[(BUILD, 2)])
    spill(tmp_path / "docs/verdicts.csv", TABLE)
    print_claims("fig3", tmp_path, tmp_path)
    command = "./reproduce.sh ensemble fig3"
    assert capsys.readouterr().out == TEXT.format(folder=folder, command=command)


def test_a_terminal_gets_no_control_characters(tmp_path, capsys):
    unseen = "\x1b]52;c;aQ==\x07\x1b[2J\u202e\ud800"
    row = asdict(replace(CLAIMS[0], id=unseen, paper=unseen, reason=unseen))
    own = {"id": unseen, "question": unseen, "measured": {unseen: unseen}}
    table = {"schema": 3, "claims": [row], "numbers": [], "builds": [[unseen, 1]]}
    spill(tmp_path / "figS5/claims.json", json.dumps(table))
    spill(tmp_path / "figS5/own.json", json.dumps([own]))
    print_claims("figS5", tmp_path, tmp_path)
    said = capsys.readouterr().out
    assert said.count("?]52;c;aQ==??[2J??") == 7
    assert said.replace("\n", "").isprintable()
    write_claims(tmp_path / "figS5/claims.json", [Claim(**row)])  # of what a store says
