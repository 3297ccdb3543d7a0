"""./reproduce.sh NAME: what is computed when something changes, fails or crashes (interruptions:
interruption_test.py); and that commands typed by hand give the same files (recipes/reproduce)."""

import copy
import json
import os
import re
import shutil
import subprocess

import pytest

from claims.table import table
from conftest import BIN, ROOT
from fixture import png
from report.written import seal
from stand_ins import Project

FILES = {
    "commands.py": '''"""Two runs, and what is measured of them and of a file."""

from functools import cache

from rupture.once import each, measured, run

from claims.recipes import RECIPES
from claims.samples import Samples
from tiny import measure

TAU_BARS = (0.1, 0.2)


def force(tau_bar):
    start = run(f"prepare --tau-bar {tau_bar} -o start.h5", keep=["start.h5"])["start.h5"]
    return run(f"analyze stress {start}").F_T, measured(measure.twice, start)


@cache
def forces():
    return dict(each(force, TAU_BARS, "runs"))


def shipped():
    return run(f"analyze phi {RECIPES.parent}/checkpoints/fast-only.h5")


def one_force():
    return Samples({"": forces()[0.1,]})


def load(sample, _):
    return {"F_N": 1920.0}
''',
    "measure.py": '''"""Of a checkpoint."""

import rupture


def twice(path):
    """Of its steps."""
    return 2 * int(rupture.open(path)["step"])
''',
    "figure.py": '''"""A figure."""

from tiny.commands import forces, shipped


def make(results):
    """It shows a force."""
    shipped()
    for ending in ("png", "pdf"):
        (results / f"tiny.{ending}").write_text(f"{[*forces().values()]} N")
''',
}
PREPARE = f"""case "$*" in *"0.2 "*) ;; *) [ ! -e "${{0%/*}}/die" ] || kill -9 $$;; esac
echo "$@" >> "${{0%/*}}/calls"
exec {BIN}/prepare "$@"
"""
WORDS = ("tiny", "--programs", "bin", "--cores", "2")
NOTHING = "Nothing to compute: all results are up to date."


class Tiny(Project):
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

    def runs(self):
        """How often `prepare` ran."""
        path = self.bin / "calls"
        return len(path.read_text().splitlines()) if path.exists() else 0

    def results(self):
        """{id: (words, when it was written)} of commands."""
        paths = (self.root / "results/store").glob("[0-9a-f][0-9a-f]/*.json")
        found = {path: json.loads(path.read_text()) for path in paths}
        return {
            p.stem: (r["command"], p.stat().st_mtime_ns) for p, r in found.items() if "command" in r
        }

    def computed(self):
        """What a call does that succeeds: words of its commands, and "tiny" if it draws."""
        before, done = self.results(), self.call(*WORDS)
        self.said = done.stderr
        assert done.returncode == 0, done.stderr + done.stdout
        drawn = re.findall(r"^\[.*\] \d+ of \d+: (\S+)", done.stdout, re.MULTILINE)
        assert (NOTHING in done.stdout) == (not drawn), done.stdout
        new = (
            words
            for own, (words, when) in self.results().items()
            if before.get(own, ("", 0))[1] != when
        )
        return sorted([*drawn, *(" ".join(one.split()[:2]) for one in new)])


@pytest.fixture(name="crashed", scope="module")
def computed_after_a_crash(tmp_path_factory):
    """A project with all results; the call before, in which a program crashed; and what `clean`
    said then."""
    tiny = Tiny(tmp_path_factory.mktemp("tiny"))
    tiny.write("bin/die")
    done = tiny.call(*WORDS)
    cleaned = tiny.call("clean", "--unneeded")
    (tiny.bin / "die").unlink()
    tiny.computed()
    return tiny, done, cleaned


@pytest.fixture(name="tiny")
def copy_of_it(crashed, tmp_path):
    return crashed[0].copied(tmp_path)


def test_a_crash_is_said_and_the_same_command_goes_on(crashed):
    first, done, cleaned = crashed
    assert done.returncode == 1
    assert "tiny: 'prepare --tau-bar 0.1 -o start.h5' ended with -9" in done.stderr
    assert done.stderr.endswith("tiny could not be computed; the messages above say why\n")
    assert "tiny was not finished, and what it needs would go: run it first" in cleaned.stderr
    assert first.runs() == 2


def test_a_mistake_in_one_figure_does_not_end_others(tiny):
    shutil.copytree(tiny.root / "recipes/tiny", tiny.root / "recipes/wrong")
    tiny.replace("recipes/wrong/figure.py", "    shipped()", "    1 / 0")
    tiny.replace("recipes/tiny/figure.py", " N", " kN")
    done = tiny.call("wrong", *WORDS)
    assert done.returncode == 1 and "2 of 2: tiny" in done.stdout
    sentence = "wrong: a mistake in its code, ZeroDivisionError('division by zero'): build/log/"
    assert sentence in done.stderr and "Traceback" not in done.stderr
    assert "in make\n    1 / 0\n" in (tiny.root / "build/log/mistakes.log").read_text()


STRESS, TWICE, PREPARED = "analyze stress", "twice start.h5", "prepare --tau-bar"
CHANGES = [  # in a file, what is replaced by what, and what follows
    ("recipes/tiny/commands.py", "(0.1, 0.2)", "(0.1, 0.2, 0.3)", [PREPARED, STRESS, TWICE]),
    ("recipes/tiny/commands.py", "(0.1, 0.2)", "(0.1,)", []),
    ("recipes/tiny/figure.py", " N", " kN", []),
    ("recipes/claims/claim.py", "\n\n", "\n\nX = 1\n", []),
    ("recipes/claims.toml", "]\n", ']\nX = "1"\n', []),
]


@pytest.mark.parametrize("name, old, new, expected", CHANGES)
def test_a_change_computes_what_it_may_touch(tiny, name, old, new, expected):
    tiny.replace(name, old, new)
    assert tiny.computed() == sorted([*expected, "tiny"])


UNTOUCHED = [
    ("recipes/tiny/figure.py", "A figure.", "Another figure."),
    ("recipes/tiny/measure.py", "    return", "    # a comment\n    return"),
    ("recipes/claims/claim.py", "\n\n", "\n\n# a comment\n"),
]


def test_words_compute_nothing_and_describe_the_results_anew(tiny):
    crate = tiny.root / "results/ro-crate-metadata.json"
    before = crate.stat().st_mtime_ns
    assert tiny.computed() == [] and crate.stat().st_mtime_ns == before
    for name, old, new in UNTOUCHED:
        tiny.replace(name, old, new)
    assert tiny.computed() == [] and crate.stat().st_mtime_ns > before


def test_what_changes_during_a_run_is_computed_by_the_next_call(tiny):
    figure = tiny.root / "recipes/tiny/figure.py"
    tiny.replace("bin/prepare", "\nexec", f"""\nsed -i 's/ N"/ kN"/' '{figure}'\nexec""")
    assert "tiny" in tiny.computed()
    assert tiny.computed() == ["tiny"]


def test_a_copy_without_hidden_files_is_whole(crashed, tmp_path):
    without = {"copy_function": shutil.copy, "ignore": shutil.ignore_patterns(".*")}
    other = crashed[0].copied(tmp_path / "copy of it", **without)
    assert other.computed() == [] and other.runs() == 2


@pytest.mark.parametrize("name", ["tiny.png", "claims.json", "commands.sh"])
def test_what_is_damaged_or_deleted_is_drawn_again(tiny, name):
    path = tiny.root / "results/tiny" / name
    before = path.read_bytes()
    path.write_text("{")
    assert tiny.computed() == ["tiny"] and path.read_bytes() == before
    assert f"{name} is gone, or not as it was written: tiny is made again" in tiny.said
    for of_others in ("true", "mkfifo", "truncate -s 1T"):
        path.unlink()
        subprocess.run([*of_others.split(), path], check=True)
        assert tiny.computed() == ["tiny"] and path.read_bytes() == before


LINKED = ("tiny", "ro-crate-metadata.json", "store/ab")


def test_a_link_in_the_place_of_what_it_writes_is_refused(tiny):
    (theirs := tiny.root / "theirs").mkdir()
    for name in LINKED:
        link = tiny.root / "results" / name
        if link.exists():
            link.rename(tiny.root / "mine")
        link.symlink_to(theirs)
        done = tiny.call(*WORDS)
        assert (done.returncode, done.stderr.count("\n")) == (1, 1), done.stderr
        assert f"results/{name} is a link, which is not followed" in done.stderr
        link.unlink()
        if (tiny.root / "mine").exists():
            (tiny.root / "mine").rename(link)
    assert not any(theirs.iterdir())


def test_results_may_be_links_themselves(tiny):
    for name in ("results/store", "results"):
        (tiny.root / name).rename(tiny.root / "disk")
        (tiny.root / name).symlink_to(tiny.root / "disk")
        assert tiny.computed() == []
        (tiny.root / name).unlink()
        (tiny.root / "disk").rename(tiny.root / name)


def test_others_files_are_not_replaced_and_ours_go_with_what_wrote_them(tiny):
    theirs = tiny.write("results/tiny/mine.csv", "mine")
    tiny.replace("recipes/tiny/figure.py", '"png", "pdf"', '"png", "svg"')
    assert tiny.computed() == ["tiny"]
    assert not (tiny.root / "results/tiny/tiny.pdf").exists() and theirs.read_text() == "mine"
    tiny.replace("recipes/tiny/figure.py", "tiny.{ending}", "mine.csv")
    done = tiny.call(*WORDS)
    assert done.returncode == 1 and "results/tiny/mine.csv is not in results/" in done.stderr
    assert theirs.read_text() == "mine"


def test_a_folder_of_others_is_left_alone(tiny):
    shutil.rmtree(tiny.root / "results")
    theirs = tiny.write("results/tiny/claims.json", "mine")
    for words in (WORDS, ("report",), (*WORDS, "--dry-run")):
        done = tiny.call(*words)
        assert (done.returncode, done.stderr.count("\n")) == (1, 1)
        assert "results has other files, and no rupture-results to say" in done.stderr
    assert "results/tiny/claims.json" in tiny.call("clean").stdout
    assert theirs.read_text() == "mine" and os.listdir(tiny.root / "results") == ["tiny"]


DRY = """# tiny
rupture analyze phi fast-only.h5
rupture prepare --tau-bar 0.1 -o start.h5
rupture analyze stress start.h5
# in Python: tiny.measure.twice start.h5
"""
WAITS = DRY.replace(
    DRY.splitlines(True)[-1],
    """# runs: 1 of 1 points wait for what a report will say
# More commands follow from reports that nobody has made yet.
""",
)


def test_a_dry_run_prints_all_commands_and_writes_nothing(tiny):
    assert tiny.call(*WORDS, "--dry-run").stdout == "# tiny\n"
    shutil.rmtree(tiny.root / "results")
    tiny.replace("recipes/tiny/commands.py", "(0.1, 0.2)", "(0.1,)")
    assert tiny.call(*WORDS, "--dry-run").stdout == WAITS
    tiny.replace("recipes/tiny/commands.py", ".F_T, measured", ", measured")
    done = tiny.call(*WORDS, "--dry-run")
    assert (done.returncode, done.stdout, done.stderr) == (0, DRY, "")
    assert not (tiny.root / "results").exists()


# --- clean -------------------------------------------------------------------------------------


def test_what_nobody_needs_any_more_goes_alone(tiny):
    assert tiny.call("clean", "--unneeded").stdout.startswith("Deleted 0 files")
    tiny.replace("recipes/tiny/commands.py", "(0.1, 0.2)", "(0.2,)")
    before = {*tiny.results()}
    tiny.computed()
    assert tiny.call("clean", "--unneeded").stdout.startswith("Deleted 4 files of results")
    gone = before - {*tiny.results()}
    assert len(gone) == 3 and tiny.computed() == []
    tiny.replace("recipes/tiny/commands.py", "(0.2,)", "(0.1, 0.2)")
    assert tiny.computed() == sorted([PREPARED, STRESS, TWICE, "tiny"])


OTHER_PAPER = """paper = { authors = "A. Author", title = "Others", journal = "J", url = "u" }
[tiny.2A]
says = "the load is 1920 N"
kind = "check"
fixed = "today"
accepted = "exactly"
samples = "one_force"
measured = "load"
conditions.F_N = 1920.0
"""


def test_another_paper_has_its_own_results_claims_and_page_which_clean_deletes(tiny):
    for name, text in FILES.items():
        tiny.write(
            f"recipes/other/tiny/{name}",
            re.sub(r"\btiny( import|\.commands)", r"other.tiny\1", text),
        )
    tiny.write("recipes/other/claims.toml", OTHER_PAPER)
    tiny.write("docs/claims.md")
    assert "  other/tiny" in tiny.call("list").stdout
    done = tiny.call("other/tiny", "--programs", "bin")
    assert "other/2A: the load is 1920 N" in done.stdout, done.stderr + done.stdout
    assert "\nother/tiny: 1 reproduced" in done.stdout
    assert tiny.computed() == []  # the other `tiny` is current
    for path in (tiny.root / "results").rglob("tiny.png"):
        path.write_bytes(png(2, 2))
        seal(tiny.root / "results", path)
    done = tiny.call("report")
    pages = [tiny.root / f"results/{paper}/index.html" for paper in (".", "other")]
    first, other = (page.read_text() for page in pages)
    assert f"0 of {len(table())} findings and checks" in first and "2A" not in first + done.stderr
    assert "1 of 1 findings and checks" in other and 'id="result-other/2A"' in other
    own = tiny.write("results/mine.json", "{}")
    done = tiny.call("clean")
    assert done.returncode == 0 and "results/store/" in done.stdout
    assert [path for path in (tiny.root / "results").rglob("*") if path.is_file()] == [own]
