"""Sweep files and their points, as recipes and users write them (recipes/common/sweeps)."""

import json
import os
import re
import sys

import pytest

from conftest import ROOT, run
from data.tables import read_rows
from rupture.errors import UsageError
from sweeps import collect
from sweeps.points import PointStore
from sweeps.sweep import Point, batches_of, read_sweep
from rupture.units import in_si
from sweeps.values import values_of

COMMANDS = "[commands]\nstart = prepare {values} -o start.h5\n"


@pytest.fixture
def read(tmp_path):
    """Reads a file with this text."""

    def read(text, name="sweep"):
        path = tmp_path / f"{name}.ini"
        path.write_text(text, encoding="utf-8")
        return read_sweep(path)

    return read


@pytest.mark.parametrize(
    "text, expected",
    [
        ("0 to 0.4 by 0.1", "0 0.1 0.2 0.3 0.4"),
        ("0 to 0.3 by 0.1", "0 0.1 0.2 0.3"),  # 0.3/0.1 is below 3
        ("0 to 0.3 in 4", "0 0.1 0.2 0.3"),
        ("5 to 1 by -2", "5 3 1"),
        ("2 to 2 in 1", "2"),
        ("1 to 3", "1 2 3"),
        ("0 to 1 by 0.4", "0 0.4 0.8"),
        ("1e-3, 0.002,bell", "1e-3 0.002 bell"),
        ("1mm/s, 2e-3", "1mm/s 2e-3"),
        ("0, 1mm/s,2mm/s", "0 1mm/s 2mm/s"),
        ("1 to 3 ms", "1ms 2ms 3ms"),
        ("0 to 2mm/s by 1 mm/s", "0mm/s 1mm/s 2mm/s"),
        ("1um to 3µm by 1μm", "1μm 2μm 3μm"),
    ],
)
def test_lists_and_ranges(text, expected):
    assert values_of(text) == expected.split()


WRONG_LISTS = {
    "no values: the step": ["0 to 1 by 0", "0 to 1 by -1", "0 to 1 in 0", "1 to -1e300 by 1e-300"],
    "more than 100,000 values": ["0 to 1 in 1e300", "1 to 1e7", "1 to 1e300 by 1e-300"],
    "'x' is not a number": ["0 to x by 1"],
    "'inf' is not a number": ["1 to inf"],
    "'nan' is not a number": ["0 to 1 by nan"],
    "must be finite": ["0 to 1 in 1e400", "-1e308 to 1e308"],
    "must be whole": ["0 to 1 in 2.5"],
    "give its step": ["0.1 to 0.5", "1 to 2.5", "1.5 to 3 ms"],
    "the same unit": ["1ms to 2s by 1ms", "1ms to 2ms in 3ms"],
    "has an empty value": ["1,,2", ""],
    "is unclear: write 0.4mm/s, or 0mm/s, 4mm/s$": ["0,4mm/s"],
    "is unclear: write 0.1mm/s, 4 mm/s$": ["0.1, 4 mm/s", "0.1,4 mm/s"],
}


@pytest.mark.parametrize("sentence", WRONG_LISTS)
def test_wrong_lists_and_ranges(sentence):
    for text in WRONG_LISTS[sentence]:
        with pytest.raises(ValueError, match=f"'{text}'.*{sentence}"):
            values_of(text)


@pytest.mark.parametrize(
    "text, number, unit",
    [
        ("10ms", 0.01, "s"),
        ("0.8 s", 0.8, "s"),
        ("-.5e1", -5, ""),
        ("3GPa", 3e9, "Pa"),
        ("75.6g", 0.0756, "kg"),
        ("1kg", 1, "kg"),
        ("4kN/m", 4000, "N/m"),
        ("0.3µm", 0.3e-6, "m"),
        ("1mm", 1e-3, "m"),
        ("1m", 1, "m"),
        ("2mm/s", 0.002, "m/s"),
        ("1e999", float("inf"), ""),
        ("1e99999999ms", float("inf"), "s"),
    ],
)
def test_numbers_with_units(text, number, unit):
    assert in_si(text) == (number, unit)


@pytest.mark.parametrize(
    "text", ["1k", "1 1", "10Ms", "nan", "1mmm", "1 kHz", "N/m^2", "", "1e-400", "1e-323ms"]
)
def test_no_numbers(text):
    with pytest.raises(ValueError, match="is not a number"):
        in_si(text)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("a = 1, 2\nb = 3, 4", "a1b3 a1b4 a2b3 a2b4"),  # the last one varies fastest
        ("c = sqrt({b})\nb = {a} ** 2 * 4\na = 1, 3", "c2b4a1 c6b36a3"),
        ("a = -2\nb = {a} ** 2", "a-2b4"),
        ("a = 2ms\nb = 0.3 * {a}", "a2msb0.0006"),
        ("a = 4 kN/m\nb = {a} / 2", "a4_kN/mb2000"),
        ("a = 1, 2  # both\n", "a1 a2"),
        # variants replace common values
        (
            "a = 1\nb = 2\n[variant X]\na = 5, 6\n[variant Y]\nb = 7",
            "variantXa5b2 variantXa6b2 variantYa1b7",
        ),
    ],
)
def test_every_combination_is_a_point(read, text, expected):
    points = read(f"[sweep]\n{COMMANDS}[values]\n{text}").points
    found = ["".join(sum(point.values.items(), ())).replace(" ", "_") for point in points]
    assert found == expected.split()


def test_the_same_again_with_another_seed(read, tmp_path):
    text = (
        f"[sweep]\nseeds = 2, 3\n{COMMANDS}"
        "[values]\na = 1, 2\n[variant x]\nnumerics.seed = 7\n[variant y]\nb = 3\n"
    )
    first, again = read(text), read_sweep(tmp_path / "sweep.ini", "3")
    assert (first.seeds, first.seed, again.seed) == (["2", "3"], "", "3")
    for one, other in zip(first.points, again.points, strict=True):
        assert other.values == one.values | {"numerics.seed": "3"}
    assert read(text.replace("seeds = 2, 3\n", "")).points == first.points


def test_options_and_parameters(read):
    text = "[values]\ntau-bar = 0.1\njunctions.t_R = 0.8 s\nshape = $HOME\n[variant v]\n"
    command = read(f"[sweep]\n{COMMANDS}{text}").points[0].commands["start"]
    expected = "prepare --tau-bar 0.1 --set 'junctions.t_R=0.8 s' --shape '$HOME' -o start.h5"
    assert command == expected


def test_points_from_a_table(read, tmp_path):
    text = f"[sweep]\npoints = ../points.csv\n{COMMANDS}[values]\nseed = 1, 2"
    (tmp_path / "x").mkdir()
    assert read(text, "x/sweep").points == []
    table = tmp_path / "points.csv"
    for content in (b"a, b\n1, 2\n3,4\n", b"\xef\xbb\xbfa,b\r\n1,2\r\n\r\n3,4\r\n"):
        table.write_bytes(content)
        found = [tuple(p.values.values()) for p in read(text, "x/sweep").points]
        assert found == [("1", "1", "2"), ("2", "1", "2"), ("1", "3", "4"), ("2", "3", "4")]
        assert list(read(text, "x/sweep").points[0].values) == ["seed", "a", "b"]
    table.write_text("driving.V [mm/s],variant,status,v [m/s],type\n0.4,x,done,2,slow\n")
    values = {"seed": "1", "driving.V": "0.4mm/s", "variant": "x"}
    assert read(text, "x/sweep").points[0].values == values


@pytest.mark.parametrize(
    "content, sentence",
    [
        (b"a,b\n0.1\n", "points.csv, line 2: it needs as many cells as the first line"),
        (b"a,b\n0.1,1\n\n0.2,1,5\n", "points.csv, line 4: it needs as many cells"),
        (b"a,a [m]\n0.1,1\n", "points.csv: each column needs a heading of its own"),
        (b"a,\n0.1,1\n", "points.csv: each column needs a heading of its own"),
        (b"a\n\xff\n", "points.csv is not a CSV table in UTF-8"),
    ],
)
def test_wrong_tables_of_points(read, tmp_path, content, sentence):
    (tmp_path / "points.csv").write_bytes(content)
    with pytest.raises(UsageError, match=sentence):
        read(f"[sweep]\npoints = points.csv\n{COMMANDS}")


def test_sections_that_a_file_lacks_are_those_of_the_file_it_is_like(read, tmp_path):
    (tmp_path / "x").mkdir()
    text = "[values]\nA = 1, 2\n[variant v]\nb = 3\n[quantities]\nq = start.q\n"
    read(f"[sweep]\ntitle = T\n{COMMANDS}{text}")
    like = "[sweep]\nlike = ../sweep.ini\n"
    other = read(f"{like}[values]\nc = 5\n", "x/other")
    assert [p.values for p in other.points] == [{"variant": "v", "c": "5", "b": "3"}]
    assert (other.title, other.columns) == ("other", {"q": "start.q"})
    assert other.files == (f"{tmp_path}/x/other.ini", f"{tmp_path}/sweep.ini")
    own = read(f"{like}[variant w]\nA = 7\n[commands]\nx = load {{values}}\n", "x/own")
    assert [p.values for p in own.points] == [{"variant": "w", "A": "7"}]
    assert own.points[0].commands == {"x": "load --A 7"}


def test_needs_of_a_point_do_not_change_its_name(read):
    def sweep(section, values="a = 1"):
        return read(f"[sweep]\n{section}\n{COMMANDS}[values]\n{values}")

    first = sweep("")
    other = sweep("memory = 2.5 GB\nthreads = 4\ntitle = T", "a = 0, 1")
    assert (first.megabytes, first.threads) == (1000, 1)
    assert (other.megabytes, other.threads) == (2500, 4)
    sweeps = (first, other, sweep("base = x.h5"), sweep("", "a = 2"))
    names = [each.points[-1].id for each in sweeps]
    assert names[0] == names[1] and len(set(names)) == 3


WHOLE = f"[sweep]\n{COMMANDS}"


@pytest.mark.parametrize(
    "text, sentence",
    [
        ("", "no section .sweep."),
        ("[sweep]\n", "no section .commands."),
        *((f"{WHOLE}x = load {{{n}}}\n", "may refer to {values} only") for n in ("o", "values.x")),
        *((f"{WHOLE}[values]\na = {n}\n", "depend on itself") for n in ("{a}", "{a}.real")),
        *(  # no finite real number
            (f"{WHOLE}[values]\nb = 9\na = {text}", re.escape(f"'{text}' "))
            for text in ("{z} + 1", "__import__('os') * {b}", "1 / 0 * {b}", "{b} +", "{b} + x")
            + ("{b}**{b}**{b}**{b}", "sqrt({b} - 10)", "({b} - 10) ** 0.5", "{b} * 1e308 * 10")
        ),
        (f"{WHOLE}[values]\na = 1 to 1e5\nb = 1 to 1e5", "10,000,000,000 points; at most 100,000"),
        ("no section", r"line 1: expected .SECTION. first \(got 'no section'\)"),
        (f"{WHOLE}[values]\na\n", r"line 5: expected NAME = VALUE or .SECTION. \(got 'a'\)"),
        (f"{WHOLE}[values]\na = 1\na = 2\n", "'a' in section 'values' already exists"),
        (f"{WHOLE}[values]\n[values]\n", "section 'values' already exists"),
        (f"{WHOLE}[value]\na = 1\n", "no section 'value': did you mean 'values'"),
        (f"{WHOLE}[DEFAULT]\na = 1\n", "no section 'DEFAULT'"),
        (f"{WHOLE}[values]\na =\n", "'a' in .values. has no value"),
        (f"[sweep]\ntittle = x\n{COMMANDS}", "has no key 'tittle': did you mean 'title'"),
        ("[sweep]\nprepare =\n[quantities]\na = b\n", "older form.*prepare = prepare {values} -o"),
        ("[sweep]\nload = --until 1\n", "older form.*load = load --until 0.5 {values} -o"),
        ("[sweep]\nbase = b.h5\nrestart = --for 1\n", "older form.*restart = restart {base}"),
        (f"{WHOLE}[analyze]\nfront = --x 1\n", "older form.*front = analyze front record.h5"),
        (f"{WHOLE}[table]\na = b.c\n", "'table' belongs to an older form.*.quantities."),
        *(
            (f"[sweep]\n{need}\n{COMMANDS}", f"'{need}' is not understood: give a")
            for need in ("memory = 10", "memory = 0 MB", "memory = 2 kg", "memory = .")
            + ("threads = 0", "threads = 1.5")
        ),
    ],
)
def test_what_is_wrong_is_said_with_the_file(read, text, sentence):
    with pytest.raises(UsageError, match=f"sweep.ini[:,] .*{sentence}"):
        read(text)


def test_varied_are_values_that_differ_and_do_not_follow_others(read):
    sweep = read(f"{WHOLE}[values]\na = 1, 2\nb = 3\nc = 2 * {{a}}\nd = x, y")
    assert sweep.varied == ["a", "d"]


def test_a_recipe_reads_tables_of_its_own_sweeps_only():
    folders = [path.parent for path in ROOT.glob("recipes/*/rules.smk")]
    sweeps = {f"{one.name}/{path.stem}" for one in folders for path in one.glob("*.ini")}
    assert len(sweeps) > 10
    with_sweeps, found = {name.split("/")[0] for name in sweeps}, 0
    for rules in ROOT.glob("recipes/*/*.smk"):
        text = rules.read_text(encoding="utf-8")
        of_tables = r'"(?:\{DATA\}/)?([\w-]+)/[^"]*\.csv"|tables_of_seeds\(f?"([^/"]+)'
        for name in map("".join, re.findall(of_tables, text)):
            found += name in with_sweeps
            assert name not in with_sweeps or name == rules.parent.name, rules
    assert found > 5


@pytest.mark.parametrize(
    "number, jobs", [(0, 0), (1, 1), (24, 24), (64, 64), (65, 33), (859, 62), (60 * 64 + 1, 65)]
)
def test_every_point_is_in_one_batch_and_neighbours_are_apart(number, jobs):
    batches = batches_of(list(range(number)))
    assert sorted(sum(batches, [])) == list(range(number))
    assert len(batches) == jobs
    assert all(b - a == jobs for batch in batches for a, b in zip(batch, batch[1:]))


# --- computing, with a stand-in for the tools -------------------------------------------------

TOOL = """#!/bin/sh
echo "$2" >> "$CALLS"
case "$2" in
  bad) echo "tool: first" >&2; echo "tool: too large" >&2; exit 1;;
  $CRASH) kill -9 $$;;
  stop) kill -INT $$;;
esac
echo "content-sha256 abc  x.h5" > x.h5.sum; echo "{\\"v\\": {\\"w\\": [1, 2]}}"
"""


class Computing:
    def __init__(self, folder):
        self.folder, self.sweep, self.calls = folder, folder / "sweep.ini", folder / "calls"
        (folder / "tool").write_text(TOOL)
        (folder / "tool").chmod(0o755)
        (folder / "base.sum").touch()

    def batch(self, values, code="1", crash="none"):
        """Computes all values; self.computed: those that were not there."""
        self.sweep.write_text(
            "[sweep]\nbase = base\n[commands]\nfirst = tool {values} --json\n"
            f"[values]\nkind = {values}\n[quantities]\nw = first.v.w.1\nnone = first.v.x.y\n"
        )
        self.calls.write_text("")
        places = f"{ROOT}/recipes/common:{ROOT}/recipes:{ROOT}/python"
        paths = {"PYTHONPATH": places, "CALLS": str(self.calls)}
        words = (self.folder, self.sweep, "", self.folder, code, self.folder / "batch.sum")
        ids = [point.id for point in read_sweep(self.sweep).points]
        script = ROOT / "recipes/common/sweeps/points.py"
        environment = os.environ | paths | {"CRASH": crash}
        done = run(sys.executable, script, *words, *ids, env=environment)
        self.computed = self.calls.read_text().split()
        return done

    def table(self, code="1"):
        collect.main(self.sweep, "", self.folder, code, self.folder / "table.csv")
        return read_rows(self.folder / "table.csv")

    def sum(self):
        return (self.folder / "batch.sum").read_text()


@pytest.fixture
def computing(tmp_path):
    return Computing(tmp_path)


def test_a_failed_point_keeps_its_sentence(computing):
    assert computing.batch("good, bad").returncode == 0
    good, bad = computing.table()
    assert list(good) == "kind status sentence w none point digest".split()
    assert (good["status"], good["w"], good["none"]) == ("done", "2", "")
    assert (bad["status"], bad["sentence"]) == ("failed", "tool: too large")
    report = json.loads((computing.folder / f"{good['point']}.json").read_text())
    assert report["checksums"] == {"x.h5": "abc"}
    computing.batch("bad")
    with pytest.raises(SystemExit, match="tool: too large"):  # nothing but failures
        computing.table()


def test_the_digest_tells_results_apart_and_not_what_computed_them(computing):
    computing.batch("good")
    (point,) = computing.table()
    computing.batch("good", code="2")
    assert computing.table("2") == [point]
    path = computing.folder / f"{point['point']}.json"
    path.write_text(path.read_text().replace("[1, 2]", "[1, 3]"))
    assert computing.table("2")[0]["digest"] != point["digest"]


def test_a_crash_is_kept_as_unfinished_and_keeps_the_others(computing):
    def states():
        found = (json.loads(path.read_text()) for path in computing.folder.glob("*.json"))
        return sorted((each["status"], each["sentence"][-13:]) for each in found)

    done = computing.batch("a, b, c", crash="b")
    assert (done.returncode, computing.computed) == (1, ["a", "b", "c"])
    assert "ended with -9" in done.stderr
    assert states() == [("done", ""), ("done", ""), ("unfinished", "ended with -9")]
    assert not (computing.folder / "batch.sum").exists()
    assert (computing.batch("a, b, c").returncode, computing.computed) == (0, ["b"])
    assert states() == [("done", "")] * 3


def test_only_what_is_not_there_of_these_sources_and_this_base_is_computed(computing):
    computing.batch("a, b")
    first = computing.sum()
    computing.batch("a, b, c")
    assert computing.computed == ["c"]
    assert computing.sum().startswith(first)
    computing.batch("a, b", code="2")
    assert computing.computed == ["a", "b"]
    (computing.folder / "base.sum").write_text("other")
    computing.batch("a, b", code="2")
    assert computing.computed == ["a", "b"]
    assert computing.sum() == first, "equal results say so"


@pytest.mark.parametrize("text", ["", "{", "[]", "null", '{"status": "done"}'])
def test_a_damaged_result_counts_as_none(tmp_path, text):
    store, point = PointStore(tmp_path / "none/yet", "code"), Point({}, {}, "")
    store.save(point, {"status": "done"})
    assert (store.result(point), store.unfinished([point])) == ({"status": "done"}, [])
    store.path(point).write_text(text)
    assert store.unfinished([point]) == [point]


def test_an_interruption_ends_it_at_once(computing):
    assert (computing.batch("stop, b").returncode, computing.computed) == (130, ["stop"])
