"""The results in README.md agree with the tables in docs/, and these with what programs compute."""

import json
import re
import subprocess

import pytest

import rupture
from rupture.errors import Failure
from report import readme
from claims.claim import Claim, Number, Share
from claims.own_result import OwnResult
from claims.table import table
from conftest import ROOT, run
from event_numbers import crossing_time
from events import LAWS
from measure.tables import read_rows
from fixture import spill


def test_its_sentences_are_those_of_the_table_of_verdicts():
    rows = read_rows(ROOT / readme.TABLE)
    claims = {row["id"]: row for row in rows if row["kind"]}
    assert [*claims] == list(table())
    for name, row in table().items():
        assert (claims[name]["kind"], claims[name]["fixed"]) == (row["kind"], row["fixed"])
    [shown] = readme.BLOCK.findall((ROOT / readme.README).read_text(encoding="utf-8"))
    assert shown == readme.sentences(ROOT)
    assert "not run" not in shown and "{" not in shown
    assert shown.count("\n| ") == 1 + 9  # questions


def test_each_row_has_a_sentence_of_the_paper_and_each_sentence_a_row_or_a_reason():
    sentences = read_rows(ROOT / "docs/sentences.csv")
    named = [name for one in sentences for name in one["rows"].split()]
    assert {*named} == {*table()}
    assert all(bool(one["rows"]) != bool(one["no row, because"]) for one in sentences)


SHOWN = {
    "fast-slow-fast": ("time from 0.4 L to 0.6 L [ms]", crossing_time),
    "fast-only": (
        "speed of events that are fast everywhere [c_s]",
        lambda f: f["speed"] / f["c_s"],
    ),
}


@pytest.mark.parametrize("event", SHOWN)
def test_numbers_of_shown_events_are_those_that_the_programs_compute(event, folder):
    quantity, of = SHOWN[event]
    recorded = ("--record", "r.h5", "--record-every", "1e-5", "--quiet")
    run("restart", ROOT / f"checkpoints/{event}.h5", "-o", "end.h5", "--for", "0.01", *recorded)
    front = json.loads(run("analyze", "front", "r.h5", "--json").stdout)
    [row] = [row for row in read_rows(ROOT / readme.NUMBERS) if row["quantity"] == quantity]
    assert readme.short(of(front), 6) == float(row["shown"])


VERDICTS = (
    "id,kind,fixed,verdict,holds,samples,version,expected,numbers\n"
    "1D,finding,today,in part,1,2,0,,{}\n"
    "2A,finding,today,,,,,,{}\n"  # it waited for its runs
    'choices,,,,,,0,,"{""moved"": 7}"\n'
)
EXPECTED = "id,expected\n2A,0.9 to 1\n3D,reproduced\n"


TEXT = "{findings: claims} {findings: reproduced} {findings: differs} {findings: that differ} "
TEXT += "{findings: reproduced after results}; {2A: holds} of {2A: samples}, {2A: verdict}, "
TEXT += "{2A: begin [L]} {2A: slowest/c_s} {2A: raw line}; {choices: moved}; {near: met} of "
TEXT += "{near: expectations}; {findings: as expected} of {findings: expected}\n"


@pytest.fixture(autouse=True, name="sentences")
def made_up_sentences(request, monkeypatch):
    if "clone" in request.fixturenames:
        monkeypatch.setattr(readme, "SENTENCES", TEXT)
        monkeypatch.setattr(readme, "PLACES", {*readme.PLACE.findall(TEXT)})


def update(root, verdict="reproduced"):
    """Writes the README of a finding whose criterion was fixed after results, one that differs, one
    without a verdict of its own, and a check."""
    words, values = ("later, after results", "paper", "accepted"), {"begin [L]": 0.3841}
    values["slowest/c_s"] = 1 / 92.4
    shares = [Share("primary", 19, 20, 20, 0.8, 1.0), Share("raw line", 18, 20, 20, 0.7, 1.0)]
    claims = [Claim("2A", "finding", *words, values, "holds", shares, verdict, "why")]
    claims.append(Claim("3D", "finding", "before any", *words[1:], {}, "holds", [], "differs", ""))
    claims.append(Claim("1F", "check", *words, {}, "holds", [], "reproduced", ""))
    own = [
        OwnResult("near", "how?", {"a": 1.0, "b": 2.0}, {"a": {"at_most": 1}, "b": {"below": 2}})
    ]
    number = Number("slow [c_s]", 0.01, most_like=0.012, median=0.02, low=0.01, high=0.035, of="8")
    readme.update_readme(root, claims, own, [number], "0.5.0")
    return (root / readme.README).read_text()


@pytest.fixture(name="clone")
def made_up_clone(tmp_path):
    spill(tmp_path / readme.TABLE, VERDICTS)
    spill(tmp_path / readme.EXPECTED, EXPECTED)
    for name in (readme.NUMBERS, readme.PICTURE):
        spill(tmp_path / name, "old")
    spill(tmp_path / "results/fig2/fig2.png", "Figure 2")
    spill(tmp_path / readme.README, "above\n<!-- results -->\nold\n<!-- /results -->\nbelow\n")
    return tmp_path


def test_a_report_of_all_results_writes_them(clone):
    above, sentences, below = re.split(r"<!-- .* -->\n", update(clone))
    assert (above, below) == ("above\n", "below\n")
    assert (
        sentences == "2 1 1 3D 1; 19 of 20, reproduced, 0.38 c_s/92 18 of 20; 7; 1 of 2; 1 of 2\n"
    )
    rows = (clone / readme.TABLE).read_text().splitlines()
    assert [row.split(",{")[0].split(",'{")[0].split(',"{')[0] for row in rows[1:]] == [
        '2A,finding,"later, after results",reproduced,19,20,0.5.0,0.9 to 1',
        "3D,finding,before any,differs,,,0.5.0,reproduced",
        '1F,check,"later, after results",reproduced,,,0.5.0,',
        "choices,,,,,,0,",  # `all` leaves that out
        "near,,,,,,0.5.0,",
    ]
    assert (clone / readme.PICTURE).read_text() == "Figure 2"
    spill(clone / "results/fig2/fig2.png", "another version of Matplotlib")
    update(clone)
    assert (clone / readme.PICTURE).read_text() == "Figure 2", "the numbers are the same"


def test_rows_without_a_verdict_are_not_counted(clone, monkeypatch):
    rows = "2A,finding,today,,,,,,{}\n3D,finding,today,differs,,,0,,{}\n"
    spill(clone / readme.TABLE, VERDICTS.partition("\n")[0] + "\n" + rows)
    text = "{findings: claims} {findings: differs}"
    monkeypatch.setattr(readme, "SENTENCES", text)
    monkeypatch.setattr(readme, "PLACES", {*readme.PLACE.findall(text)})
    assert readme.sentences(clone) == "1 1"


def test_a_place_that_nothing_fills_is_an_error(clone, monkeypatch):
    monkeypatch.setattr(readme, "SENTENCES", TEXT.replace("begin [L]", "began [L]"))
    monkeypatch.setattr(readme, "PLACES", {*readme.PLACE.findall(readme.SENTENCES)})
    with pytest.raises(Failure, match=r"places that nothing fills: 2A: began \[L\]"):
        update(clone)


def test_one_of_some_results_or_behind_a_link_does_not(clone):
    assert "old\n" in update(clone, None)
    (clone / readme.README).rename(clone / "mine")
    (clone / readme.README).symlink_to("mine")
    assert "old\n" in update(clone)
    assert (clone / readme.TABLE).read_text() == VERDICTS


def test_the_page_of_the_model_is_current():
    page = (ROOT / "docs/model.md").read_text(encoding="utf-8")
    rows = [row.split("|")[-2] for row in page.splitlines() if row.startswith("|")]
    names = {name for row in rows for name in re.findall(r"`([\w/.:]+)`", row)}
    sources = [*(ROOT / "src").rglob("*.?pp"), *(ROOT / "include").rglob("*.?pp")]
    text = "".join(f"{path}\n{path.read_text(encoding='utf-8')}" for path in sources)
    assert len(names) > 20
    assert {name for name in names if name.split("::")[-1] not in text} == set()


def test_its_numbers_are_those_of_the_programs(folder):
    page = " ".join((ROOT / "docs/model.md").read_text(encoding="utf-8").split())
    listed = re.findall(r"([^|,]+) = ([\d.e-]+)", page.partition("## Values")[2])
    known = json.loads(run("rupture", "parameters", "--json").stdout)["parameters"]
    numbers = [one for one in known if "minimum" in one and one["symbol"] != "-"]
    defaults = {one["symbol"].replace("delta ", "delta_"): one["default"] for one in numbers}
    assert {symbol.strip(): float(value) for symbol, value in listed} == defaults
    options = json.loads(run("prepare", "--describe").stdout)["options"]
    default = {option["name"]: option["default"] for option in options}
    x, tau_bar = 1000 * default["x-trigger"], default["tau-bar-trigger"]
    law = dict(re.findall(r"junctions\.(\w+)=(\S+)", LAWS["decaying"]))
    kappa, mu_d, mu_new = float(law["kappa"]) / 1e9, law["mu_d"], law["mu_new"]
    run("prepare", "--tau-bar", "0", "-o", "p.h5")
    first = 1000 * rupture.open("p.h5")["junctions/repin_time"][0][0]
    for stated in (
        f"x_trigger ({x:g} mm), tau_bar is {tau_bar} ",
        f"kappa = {kappa} GN/m^2, mu_d = {mu_d} and mu_new = 0.7 mu_d = {mu_new}. ",
        f"the first slipping time of junction 0 of block 0 is {first:.10f} ms",
    ):
        assert stated in page


def test_no_text_uses_words_that_a_reader_cannot_know():
    texts = ["README.md", "CONTRIBUTING.md", "recipes", "python", "docs", "src"]
    grep = ["grep", "-rniIf", ".phrases", *texts]
    done = subprocess.run(grep, cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.stdout, done.returncode) == ("", 1)
