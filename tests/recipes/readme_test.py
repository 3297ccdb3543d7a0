"""The results in README.md agree with the tables in docs/, and these with what programs compute."""

import json
import re
import subprocess

import pytest

import rupture
from report import readme
from claims.claim import Claim, Number, Share
from claims.table import table
from conftest import ROOT, run
from event_numbers import crossing_time
from events import LAWS
from measure.tables import read_rows
from fixture import spill


def test_its_sentences_are_those_of_the_table_of_verdicts():
    rows = read_rows(ROOT / readme.TABLE)
    assert [row["id"] for row in rows if row["kind"]] == list(table())
    [shown] = readme.BLOCK.findall((ROOT / readme.README).read_text(encoding="utf-8"))
    assert shown == readme.sentences(ROOT)
    assert "not run" not in shown and "{" not in shown


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
    "id,kind,fixed,verdict,holds,units,version,numbers\n"
    "1D,finding,today,depends,1,2,0,{}\n"
    "2A,finding,today,,,,,{}\n"  # it waited for its runs
    "choices,,,,,,0,{}\n"
)


def update(root, verdict="reproduced"):
    """Writes the README of one finding, whose criterion was fixed after results."""
    share, words = Share("primary", 19, 20, 0.8, 1.0), ("finding", "later, after results", "paper")
    claim = Claim("2A", *words, "accepted", {}, "holds", [share], verdict, "why")
    number = Number(
        "slow [c_s]", 0.01, most_like=0.012, median=0.02, low=0.01, high=0.035, of="8 of 9 events"
    )
    readme.update_readme(root, [claim], [], [number], "0.5.0")
    return (root / readme.README).read_text()


@pytest.fixture(name="clone")
def made_up_clone(tmp_path):
    spill(tmp_path / readme.TABLE, VERDICTS)
    for name in (readme.NUMBERS, readme.PICTURE):
        spill(tmp_path / name, "old")
    spill(tmp_path / readme.FIRST, (ROOT / readme.FIRST).read_bytes())
    spill(tmp_path / "results/fig2/fig2.png", "Figure 2")
    spill(tmp_path / readme.README, "above\n<!-- results -->\nold\n<!-- /results -->\nbelow\n")
    return tmp_path


def test_a_report_of_all_results_writes_them(clone):
    above, sentences, below = re.split(r"<!-- .* -->\n", update(clone))
    assert (above, below) == ("above\n", "below\n")
    assert "in 19 of 20 runs" in sentences and "old\n" not in sentences
    assert "| slow [c_s] | 0.01 | 0.012 | 0.02 (0.01 to 0.035) |" in sentences
    assert "Of its 1 findings, 1 are reproduced, and 0 depend" in sentences
    assert "The criteria of\n1 of the reproduced findings" in sentences
    assert "26 criteria that were fixed first, 10 were" in sentences
    rows = (clone / readme.TABLE).read_text().splitlines()
    assert rows[1:] == [
        '2A,finding,"later, after results",reproduced,19,20,0.5.0,{}',
        "choices,,,,,,0,{}",
    ]  # `all` leaves that out
    assert (clone / readme.PICTURE).read_text() == "Figure 2"
    spill(clone / "results/fig2/fig2.png", "another version of Matplotlib")
    update(clone)
    assert (clone / readme.PICTURE).read_text() == "Figure 2", "the numbers are the same"


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
