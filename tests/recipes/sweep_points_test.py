"""Points of a sweep, with stand-ins for programs: what is filled in, left out, refused, kept; and
what --dry-run says of them (recipes/sweeps/points.py, estimate.py)."""

import shutil
from pathlib import Path

import pytest

from conftest import BIN, ROOT
from rupture import once
from sweeps.estimate import Estimate
from sweeps.points import Points
from sweeps.sweep import Sweep

ANALYZE = f"""#!/bin/bash
case "$*" in *--describe*|quantities*|checksum*) exec {BIN}/analyze "$@";; esac
printf '%s\\n' "analyze" "$@" > "CALLS/$RANDOM$RANDOM"
case "$*" in *" bad.h5"*) echo "analyze: too large" >&2; exit 1;; *crash.h5*) kill -9 $$;; esac
echo '{{"t_rupture": [0.25, null, 2.0], "slow": null, "type": "fast", "speed": -3.5}}'
"""
RUN = f"""#!/bin/bash
case "$*" in *--describe*|*--dry-run*) exec {BIN}/NAME "$@";; esac
printf '%s\\n' NAME "$@" > "CALLS/$RANDOM$RANDOM"
while [ "$1" != -o ]; do shift; done
echo > "$2"; echo '{{"files": []}}'
"""
HEAD = "[sweep]\nkeep = a.h5\n[commands]\na = restart in.h5 --for {t} -o a.h5\n"
TAIL = "[values]\nt = 1ms, 2ms\n[quantities]\ntype = f.type\nv = f.t_rupture.2\n"


@pytest.fixture(name="rows")
def rows_of_a_sweep(folder, monkeypatch):
    """The rows of a sweep with these commands, and the words of all that ran."""
    (folder / "bin").mkdir()
    (folder / "calls").mkdir()
    shutil.copyfile(ROOT / "checkpoints/fast-only.h5", "in.h5")
    shutil.copyfile("in.h5", "bad.h5")
    shutil.copyfile("in.h5", "crash.h5")
    for name, text in (("analyze", ANALYZE), ("restart", RUN), ("prepare", RUN)):
        text = text.replace("CALLS", str(folder / "calls")).replace("NAME", name)
        (folder / "bin" / name).write_text(text)
        (folder / "bin" / name).chmod(0o755)
    (folder / "bin/parameters").symlink_to(Path(BIN, "parameters"))
    monkeypatch.setenv("RUPTURE_BIN", str(folder / "bin"))

    def rows(commands, tail=TAIL, head=HEAD):
        Path("x.ini").write_text(f"{head}{commands}{tail}")
        sweep = Sweep(folder / "x.ini")
        making = once.use("store", cores=2, dry_run=False)
        found = [row for _, row in once.each(Points(sweep, making).compute, sweep.points)]
        once.finish()
        ran = [path.read_text().splitlines() for path in (folder / "calls").iterdir()]
        return found, ran

    return rows


def test_reports_are_filled_in_and_the_words_that_are_checked_run(rows):
    later = "f = analyze front a.h5\nb = restart a.h5 --until {f.t_rupture.0} -o b.h5\n"
    later += (
        "g = analyze front b.h5\nc = restart a.h5 --set 'driving.V={f.speed}' --for 1 -o c.h5\n"
    )
    found, ran = rows(f"{later}h = analyze front c.h5\n")
    assert [row["status"] for row in found] == ["done"] * 2
    assert [(row["type"], row["v"]) for row in found] == [("fast", 2.0)] * 2
    assert ["restart", "a.h5", "--until", "0.25", "-o", "b.h5", "--quiet", "--json"] in ran
    words = ["restart", "a.h5", "--set", "driving.V=-3.5", "--for", "1", "-o", "c.h5"]
    assert [*words, "--quiet", "--json"] in ran
    for row in found:
        assert Path("store", row["a.h5"].removeprefix("store/")).exists() and row["point"]


@pytest.mark.parametrize("name, word", [("a 'b' \"c\" $(x); y.h5",) * 2, ("x/--force", "_--force")])
def test_a_value_is_one_word_and_no_option_whatever_is_in_it(rows, name, word):
    Path("x").mkdir()
    quoted = name.replace('"', '""')
    Path("p.csv").write_text(f'file\n"{quoted}"\n')
    shutil.copyfile("in.h5", name)
    head = "[sweep]\npoints = p.csv\n[commands]\n"
    found, ran = rows("f = analyze front {file}\n", "[quantities]\ntype = f.type\n", head)
    assert ran == [["analyze", "front", word, "--json"]]
    assert [row["status"] for row in found] == ["done"]


NULLS = "f = analyze front a.h5\nb = restart a.h5 --until {f.t_rupture.1} -o b.h5\n"


def test_what_needs_a_null_is_left_out_and_said(rows):
    found, ran = rows(f"{NULLS}g = analyze front b.h5\n", f"{TAIL}w = g.type\n")
    assert [(row["status"], row["type"], row["w"]) for row in found] == [("done", "fast", None)] * 2
    why = "was left out, because it needs a value that is null"
    assert found[0]["sentence"] == f"b {why}; g {why}"
    assert len(ran) == 4


@pytest.mark.parametrize(
    "file, status, sentence",
    [("bad", "refused", "analyze: too large"), ("crash", "unfinished", ".* ended with -9.*")],
)
def test_a_refusal_is_a_result_and_a_crash_is_none_and_others_go_on(rows, file, status, sentence):
    tail = f"[values]\nn = {file}, in\n[quantities]\ntype = f.type\n"
    head = "[sweep]\n[commands]\n"
    for count in (2, 2 + (file == "crash")):
        found, ran = rows("f = analyze front {n}.h5\n", tail, head)
        assert [row["status"] for row in found] == [status, "done"]
        assert found[0]["sentence"].startswith(sentence.partition(".*")[0])
        assert [row["type"] for row in found] == [None, "fast"]
        assert len(ran) == count


def test_what_reports_give_is_checked_again(rows):
    bad = "b = restart a.h5 --for 1 --set junctions.law={f.type} -o b.h5\ng = analyze front b.h5\n"
    found, _ = rows(f"f = analyze front a.h5\n{bad}")
    assert {row["status"] for row in found} == {"refused"}
    assert "junctions.law must be reference or" in found[0]["sentence"]


# --- before anything runs --------------------------------------------------------------------

FAR = """[sweep]
base = in.h5
keep = e.h5
[commands]
far = restart {base} --for 12 -o e.h5 --record r.h5 {values}
f = analyze front r.h5
later = restart e.h5 --for 1 -o l.h5
g = analyze front l.h5
[values]
numerics.dt = 2e-7, 1
[quantities]
type = g.type
"""


def test_a_dry_run_adds_up_what_programs_say_and_shows_what_they_refuse(folder):
    shutil.copyfile(ROOT / "checkpoints/fast-only.h5", "in.h5")
    Path("x.ini").write_text(FAR)
    sweep = Sweep(folder / "x.ini")
    estimate = Estimate(sweep)
    estimate.ask(sweep.points)
    each, kept, unknown, refused, sentence = estimate.lines(2)
    assert each.startswith("Each point takes ") and " min" in each, "12 without a unit are seconds"
    assert " with " in each and " MB, " in each
    assert kept.startswith("Files that are kept take ")
    assert unknown == "Not counted, because they start from what runs find: later."
    assert (refused, sentence.split(" x ")[0]) == ("Refused:", "  1")
    assert {path.name for path in folder.iterdir()} == {"in.h5", "x.ini"}
