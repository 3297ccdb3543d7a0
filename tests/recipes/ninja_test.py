"""Recipes of chains, by Ninja: what is computed when something changes, fails or crashes; and that
commands typed by hand give the same files (recipes/chains)."""

import copy
import json
import os
import re
import shutil
import subprocess
from unittest.mock import Mock, patch

import pytest

from chains import digests, progress
from chains.point import compute as compute_point
from chains.selection import Chains
from claims.judge import table
from conftest import BIN, ROOT, run
from fixture import png
from reproduce import compute
from report.written import append_to
from stand_ins import Project

FILES = {
    "figure.ini": "[figure]\nreads = measured, shipped\n",
    "runs.ini": "[chain]\nkeep = start.h5\n[commands]\nstart = prepare {values} -o start.h5\n"
    "[values]\ntau-bar = 0.1, 0.2\n",
    "measured.ini": "[chain]\npoints = runs\nbase = runs: start.h5\n[commands]\n"
    "stress = analyze stress {base}\n",
    "shipped.ini": "[chain]\nbase = ../../checkpoints/fast-only.h5\n[commands]\n"
    "phi = analyze phi {base}\n",
    "figure.py": '''"""A figure."""


def make(chains, results):
    """It shows a force."""
    for ending in ("png", "pdf"):
        forces = [p["stress"]["F_T"] for p in chains["measured"] if p.status == "done"]
        (results / f"tiny.{ending}").write_text(f"{forces} N")
    return []
''',
}
PREPARE = f"""[ ! -e "${{0%/*}}/die" ] || kill -9 $$
exec {BIN}/prepare "$@"
"""
RUNS, MEASURED, FIGURE = ["tiny/runs"] * 2, ["tiny/measured"] * 2, ["tiny"]


class Tiny(Project):
    """With a recipe of two runs, what is measured of them, and what is measured of a file."""

    def __init__(self, root):
        super().__init__(root)
        self.link("load", "modify-phi", "restart", "analyze")
        self.program("prepare", PREPARE)
        shutil.copytree(ROOT / "checkpoints", root / "checkpoints")
        for name, text in FILES.items():
            self.write(f"recipes/tiny/{name}", text)

    def copied(self, root, **options):
        shutil.copytree(self.root, root, symlinks=True, dirs_exist_ok=True, **options)
        other = copy.copy(self)
        other.root, other.bin = root, root / "bin"
        return other

    def reproduce(self):
        return self.call("tiny", "--programs", "bin", "--cores", "2")

    def jobs(self):
        """Rules of the jobs that were noted."""
        lines = (self.root / "results/jobs.jsonl").read_text().splitlines()
        return [json.loads(line)["rule"] for line in lines]

    def computed(self):
        """The jobs of a call that succeeds. It says so if there are none."""
        before, done = len(self.jobs()), self.reproduce()
        assert done.returncode == 0, done.stderr + done.stdout
        steps = re.findall(r"^\[.*\] \d+/\d+ (.*)", done.stdout, re.MULTILINE)
        assert ("Nothing to compute" in done.stdout) == (not steps), done.stdout
        self.said = done.stdout
        return sorted(self.jobs()[before:])

    def crate(self):
        return self.root / "results/ro-crate-metadata.json"


@pytest.fixture(name="crashed", scope="module")
def computed_after_a_crash(tmp_path_factory):
    """A project with all results, and the call before, in which a program crashed."""
    tiny = Tiny(tmp_path_factory.mktemp("tiny"))
    tiny.write("bin/die")
    done = tiny.reproduce()
    (tiny.bin / "die").unlink()
    tiny.computed()
    return tiny, done


@pytest.fixture(name="tiny")
def copy_of_it(crashed, tmp_path):
    return crashed[0].copied(tmp_path)


def test_a_crash_is_said_and_the_same_command_goes_on(crashed):
    first, done = crashed
    assert done.returncode == 1
    assert "Failed: tiny/runs: tau-bar 0.1\n  to make: results/data/points/" in done.stderr
    assert "'prepare --tau-bar 0.1 -o start.h5' ended with -9" in done.stderr
    assert done.stderr.endswith("say why (log: build/log/recipes.log)\n")
    assert sorted(first.jobs()) == sorted([*RUNS, *MEASURED, "tiny/shipped", *FIGURE])


def test_jobs_and_files_are_noted_for_the_report_and_the_crate(crashed):
    first, _ = crashed
    last = json.loads((first.root / "results/jobs.jsonl").read_text().splitlines()[-1])
    assert last["rule"] == "tiny" and "results/tiny/claims.json" in last["output"]
    assert "recipes/tiny/figure.py" in last["command"]
    by_id = {each["@id"]: each for each in json.loads(first.crate().read_text())["@graph"]}
    run_of_tiny = by_id["#run-tiny"]
    assert run_of_tiny["startTime"] <= run_of_tiny["endTime"]
    starts = {f"data/points/{path.name}" for path in first.stored(".start.h5")}
    assert {each["@id"] for each in run_of_tiny["object"]} == starts
    for start in starts:
        checksum = run("analyze", "checksum", first.root / "results" / start).stdout.split()[0]
        assert by_id[start]["identifier"] == f"content-sha256:{checksum}"


CHANGES = [  # in a file, what is replaced by what, and the jobs that follow
    ("recipes/tiny/measured.ini", "{base}", "{base}\nphi = analyze phi {base}", MEASURED + FIGURE),
    ("recipes/tiny/runs.ini", "0.2", "0.2, 0.3", RUNS[:1] + MEASURED[:1] + FIGURE),
    ("recipes/tiny/runs.ini", "0.1, 0.2", "0.1", FIGURE),
    ("recipes/tiny/figure.py", " N", " kN", FIGURE),
    ("recipes/claims/claim.py", "\n\n", "\n\nX = 1\n", FIGURE),
    ("recipes/claims.toml", "]\n", ']\nX = "1"\n', FIGURE),
    ("bin/prepare", "exec", ": ; exec", RUNS),  # what it writes is equal
]


@pytest.mark.parametrize("name, old, new, expected", CHANGES)
def test_a_change_computes_what_it_may_touch(tiny, name, old, new, expected):
    tiny.replace(name, old, new)
    assert tiny.computed() == sorted(expected)


UNTOUCHED = [
    ("recipes/tiny/measured.ini", "stress =", "; a sentence\nstress ="),
    ("recipes/tiny/runs.ini", "[chain]", "[chain]\nmemory = 2 GB\nthreads = 2"),
    ("recipes/tiny/figure.py", "A figure.", "Another figure."),
    ("recipes/tiny/figure.py", "    forces", "    # a comment\n        forces"),
    ("recipes/claims/claim.py", "\n\n", "\n\n# a comment\n"),
]


def test_words_compute_nothing_and_describe_the_results_anew(tiny):
    before = tiny.crate().stat().st_mtime_ns
    assert tiny.computed() == [] and tiny.crate().stat().st_mtime_ns == before
    for name, old, new in UNTOUCHED:
        tiny.replace(name, old, new)
    assert tiny.computed() == [] and tiny.crate().stat().st_mtime_ns > before


def test_what_changes_during_a_run_is_computed_by_the_next_call(tiny):
    figure = tiny.root / "recipes/tiny/figure.py"
    tiny.replace("bin/prepare", "exec", f"""sed -i 's/ N"/ kN"/' '{figure}'\nexec""")
    assert tiny.computed() == RUNS
    assert tiny.computed() == FIGURE


BEHIND: tuple = ("bin/prepare", "recipes/*/runs.ini", "python/rupture/units.py", "checkpoints/*.h5")
BEHIND += ("results/data/points/*.json", "results/data/points/*.h5", "results/tiny/*.png")


@pytest.mark.parametrize("place", BEHIND)
def test_any_other_date_is_a_reason_to_look_closer(crashed, monkeypatch, place):
    """Also an earlier one."""
    monkeypatch.chdir(crashed[0].root)
    monkeypatch.setenv("RUPTURE_BIN", "bin")
    monkeypatch.setattr(compute, "SHARE", crashed[0].root)
    wanted, path = {"recipes": ["tiny"]}, next(crashed[0].root.glob(place))
    state, date = compute.state_of(wanted), path.stat().st_mtime_ns
    os.utime(path, ns=(date, date - 1))
    assert compute.state_of(wanted) != state
    os.utime(path, ns=(date, date))
    assert compute.state_of(wanted) == state != compute.state_of({"recipes": []})


def test_dates_and_the_folder_do_not_count(crashed, tmp_path):
    other = crashed[0].copied(tmp_path / "copy of it", copy_function=shutil.copy)
    assert set(other.computed()) <= {"tiny"}


def test_what_is_damaged_edited_or_deleted_is_computed_again(tiny):
    results = {path: path.read_text() for path in tiny.stored(".json")}
    damaged, deleted = tiny.stored(".start.h5")
    deleted.unlink()
    damaged.with_name(damaged.name.replace("start.h5", "json")).write_text("{")
    assert tiny.computed() == RUNS
    next(p for p, text in results.items() if "stress" in text).write_text('{"status": "done"}')
    assert tiny.computed() == FIGURE + MEASURED[:1]
    assert results == {path: path.read_text() for path in tiny.stored(".json")}


def test_what_starts_from_another_file_is_computed_again(tiny):
    shutil.copyfile(ROOT / "checkpoints/second-slow.h5", tiny.root / "checkpoints/fast-only.h5")
    assert tiny.computed() == ["tiny", "tiny/shipped"]
    assert "1 of 1 points failed: checkpoints/fast-only.h5 is not in" in tiny.said


def test_a_failed_point_is_a_result_and_its_sentence_is_said(tiny):
    tiny.replace("recipes/tiny/runs.ini", "0.1, 0.2", "0.1, 9")
    assert tiny.computed() == sorted(RUNS[:1] + MEASURED[:1] + FIGURE)
    assert re.search("measured: 1 of 2 points failed: prepare: .*tau", tiny.said)
    assert tiny.computed() == []


def test_a_wrong_name_is_said_before_anything_runs(tiny):
    tiny.replace("recipes/tiny/measured.ini", "{base}\n", "{bas}\n")
    tiny.replace("recipes/tiny/runs.ini", "0.2", "0.2, 0.3")
    before, done = tiny.jobs(), tiny.reproduce()
    assert (done.returncode, tiny.jobs()) == (2, before)
    sentence = "measured.ini, line 5: 'bas': there is no 'bas'; there are start, stress"
    assert f"recipes/tiny/{sentence}" in done.stderr


LINKED = ("figS1", "jobs.jsonl") + tuple(
    f"data/{n}" for n in ("plan/.ninja_log", "points/x.todo", "digests/load", "spare/x")
)


def test_a_link_in_the_place_of_what_it_writes_is_refused(tiny):
    (theirs := tiny.root / "theirs").mkdir()
    for name in LINKED:
        link = tiny.root / "results" / name
        link.parent.mkdir(exist_ok=True)
        link.unlink(missing_ok=True)
        link.symlink_to(theirs)
        done = tiny.reproduce()
        assert (done.returncode, done.stderr.count("\n")) == (1, 1)
        assert f"results/{name} is a link, which is not followed" in done.stderr
        link.unlink()
    link.symlink_to(theirs / "file")
    with pytest.raises(OSError):
        append_to(link)
    assert not any(theirs.iterdir())


def test_a_dry_run_prints_all_commands_and_writes_nothing(tiny):
    shutil.rmtree(tiny.root / "results")
    done = tiny.call("tiny", "--dry-run")
    assert done.returncode == 0, done.stderr
    start, stress, other, *_ = re.split("\n\n", done.stdout)
    assert start == "# tiny/runs: tau-bar 0.1\nrupture prepare --tau-bar 0.1 -o start.h5"
    assert other.startswith("# tiny/runs: tau-bar 0.2\nrupture prepare --tau-bar 0.2")
    assert re.fullmatch(
        "# tiny/measured: tau-bar 0.1\n# start.h5 is results/data/points/[0-9a-f]{16}.start.h5\n"
        "rupture analyze stress start.h5",
        stress,
    )
    assert not (tiny.root / "results").exists()


OTHER_PAPER = """paper = { authors = "A. Author", title = "Others", journal = "J", url = "u" }
[tiny.2A]
says = "the load is 1920 N"
kind = "check"
fixed = "today"
accepted = "exactly"
shown = "measured where tau-bar == 0.1"
measured.F_N = "stress.F_N"
conditions.F_N = 1920.0
"""


def test_another_paper_has_its_own_results_claims_and_page_which_clean_deletes(tiny):
    shutil.copytree(tiny.root / "recipes/tiny", tiny.root / "recipes/other/tiny")
    tiny.replace("recipes/other/tiny/shipped.ini", "..", "../..")
    tiny.write("recipes/other/claims.toml", OTHER_PAPER)
    tiny.write("docs/claims.md")
    assert "  other/tiny" in tiny.call("list").stdout
    done = tiny.call("other/tiny", "--programs", "bin")
    assert "other/2A: the load is 1920 N" in done.stdout, done.stderr
    assert "\nother/tiny: 1 reproduced" in done.stdout
    assert tiny.jobs()[-1] == "other/tiny" and tiny.computed() == []  # the other `tiny` is current
    for path in (tiny.root / "results").rglob("tiny.png"):
        path.write_bytes(png(2, 2))
    done = tiny.call("report")
    pages = [tiny.root / f"results/{paper}/index.html" for paper in (".", "other")]
    first, other = (page.read_text() for page in pages)
    assert f"0 of {len(table())} findings and checks" in first and "2A" not in first + done.stderr
    assert "1 of 1 findings and checks" in other and 'id="result-other/2A"' in other
    own = tiny.write("results/data/points/mine.json", "{}")
    assert tiny.call("clean").returncode == 0
    assert [path for path in (tiny.root / "results").rglob("*") if path.is_file()] == [own]


NINJA = """[1/4] a: x 1
[2/4] plan what follows from these
FAILED: results/1.json results/2.json
sh -c 'a'
first
{many}
last
[1/2] b
  1 of 2 points failed
ninja: error: no
ninja: build stopped: subcommand failed.
"""


@pytest.mark.parametrize("part, rest", [(1 / 3, ", about 18 s left"), (0.6, "")])
def test_what_ninja_says_is_said_in_our_words(capsys, folder, part, rest):
    lines = NINJA.format(many="\n".join(["more"] * 40)).splitlines()
    with patch("time.monotonic", Mock(side_effect=[0, 5, 12, 30])):
        assert progress.follow(iter(lines), part)
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "[   5 s] 1/4 a: x 1",
        f"[  30 s{rest}] 1/2 b",
        "    1 of 2 points failed",
    ]
    failed, making, *more, last, error = said.err.strip().splitlines()
    assert failed == "Failed: plan what follows from these"
    assert making == "  to make: results/1.json"
    assert set(more) == {"  more"} and len(more) == 29
    assert (last, error) == ("  last", "ninja: error: no")
    assert not progress.follow(iter(["ninja: no work to do."]))


# --- by hand -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["figS3/profiles", "figS1/forces"])
def test_commands_typed_by_hand_give_the_same_files(folder, name):
    (folder / "checkpoints").symlink_to(ROOT / "checkpoints")
    chains = Chains()
    point = chains.points(chains.load(ROOT / f"recipes/{name}.ini"))[-1]
    typed = "\n".join(point.commands.values())
    path = {"PATH": f"{BIN}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-ec", typed], env=os.environ | path, check=True)
    (folder / "in").mkdir()
    checksums = compute_point(point.work, "in")["checksums"]
    assert checksums.keys() == {path.name for path in folder.glob("*.h5")}
    for file, checksum in checksums.items():
        assert run("analyze", "checksum", file).stdout.split() == [checksum]


# --- programs as digests -----------------------------------------------------------------------


def test_a_program_is_what_it_computes_with_and_not_its_version(tmp_path):
    content = (BIN / "restart").read_bytes()
    listed = run("readelf", "--sections", "--wide", BIN / "restart").stdout
    others = {}
    for name, start, size in re.findall(r" (\.\S+) +\w+ +\w+ (\w+) (\w+)", listed):
        middle = int(start, 16) + int(size, 16) // 2
        path = tmp_path / name[1:]
        path.write_bytes(content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :])
        others[name] = digests.digest_of_program(path)
    known = digests.digest_of_program(BIN / "restart")
    assert {others[".rupture_version"], others[".note.gnu.build-id"]} == {known}
    assert known not in (others[".text"], others[".rodata"], others[".data"])
    assert digests.digest_of_program(BIN / "analyze") != known
