"""A user's sweep by Ninja: what is computed when something changes, fails or crashes; and that
commands typed by hand give the same files (recipes/chains)."""

import copy
import json
import os
import shutil
import subprocess
from unittest.mock import Mock, patch

import pytest

from chains import progress
from chains.point import compute as compute_point
from chains.sweeps import OwnSweep
from conftest import BIN, ROOT, run
from report.written import append_to
from stand_ins import Project

FILES = {
    "runs.ini": "[chain]\nkeep = start.h5\n[commands]\nstart = prepare {values} -o start.h5\n"
    "[values]\ntau-bar = 0.1, 0.2\n",
    "my.ini": "[sweep]\npoints = runs\nbase = runs: start.h5\n[commands]\n"
    "stress = analyze stress {base}\n[quantities]\nF_T = stress.F_T\n",
}
PREPARE = f"""case "$*" in *--describe*) ;; *) [ ! -e "${{0%/*}}/die" ] || kill -9 $$;; esac
exec {BIN}/prepare "$@"
"""
RUNS, MEASURED = ["runs"] * 2, ["my"] * 2


class Tiny(Project):
    """With a sweep of two runs and what is measured of them."""

    def __init__(self, root):
        super().__init__(root)
        self.link("load", "modify-phi", "restart", "analyze")
        self.program("prepare", PREPARE)
        for name, text in FILES.items():
            self.write(name, text)

    def copied(self, root, **options):
        shutil.copytree(self.root, root, symlinks=True, dirs_exist_ok=True, **options)
        other = copy.copy(self)
        other.root, other.bin = root, root / "bin"
        return other

    def sweep(self):
        return self.call("sweep", "my.ini", "--programs", "bin", "--cores", "2")

    def jobs(self):
        """Files whose points were noted."""
        path = self.root / "results/jobs.jsonl"
        lines = path.read_text().splitlines() if path.exists() else ()
        return [json.loads(line)["rule"] for line in lines]

    def computed(self):
        """The jobs of a call that succeeds."""
        before, done = len(self.jobs()), self.sweep()
        assert done.returncode == 0, done.stderr + done.stdout
        self.said = done.stdout
        return sorted(self.jobs()[before:])


@pytest.fixture(name="crashed", scope="module")
def computed_after_a_crash(tmp_path_factory):
    """A project with all results, and the call before, in which a program crashed."""
    tiny = Tiny(tmp_path_factory.mktemp("tiny"))
    tiny.write("bin/die")
    done = tiny.sweep()
    (tiny.bin / "die").unlink()
    tiny.computed()
    return tiny, done


@pytest.fixture(name="tiny")
def copy_of_it(crashed, tmp_path):
    return crashed[0].copied(tmp_path)


def test_a_crash_is_said_and_the_same_command_goes_on(crashed):
    first, done = crashed
    assert done.returncode == 1
    assert "Failed: runs: tau-bar 0.1\n  to make: results/data/points/" in done.stderr
    assert "'prepare --tau-bar 0.1 -o start.h5' ended with -9" in done.stderr
    assert sorted(first.jobs()) == sorted([*RUNS, *MEASURED])


CHANGES = [  # in a file, what is replaced by what, and the jobs that follow
    ("my.ini", "{base}", "{base}\nphi = analyze phi {base}", MEASURED),
    ("runs.ini", "0.2", "0.2, 0.3", RUNS[:1] + MEASURED[:1]),
    ("runs.ini", "0.1, 0.2", "0.1", []),
    ("bin/prepare", "exec", ": ; exec", RUNS),  # what it writes is equal
    ("my.ini", "stress =", "; a sentence\nstress =", []),
    ("runs.ini", "[chain]", "[chain]\nmemory = 2 GB\nthreads = 2", []),
]


@pytest.mark.parametrize("name, old, new, expected", CHANGES)
def test_a_change_computes_what_it_may_touch(tiny, name, old, new, expected):
    tiny.replace(name, old, new)
    assert tiny.computed() == sorted(expected)


def test_dates_and_the_folder_do_not_count(crashed, tmp_path):
    other = crashed[0].copied(tmp_path / "copy of it", copy_function=shutil.copy)
    assert other.computed() == []


def test_what_is_damaged_edited_or_deleted_is_computed_again(tiny):
    results = {path: path.read_text() for path in tiny.stored(".json")}
    damaged, deleted = tiny.stored(".start.h5")
    deleted.unlink()
    damaged.with_name(damaged.name.replace("start.h5", "json")).write_text("{")
    assert tiny.computed() == RUNS
    next(p for p, text in results.items() if "stress" in text).write_text('{"status": "done"}')
    assert tiny.computed() == MEASURED[:1]
    assert results == {path: path.read_text() for path in tiny.stored(".json")}


def test_a_failed_point_is_a_result_and_its_sentence_is_said(tiny):
    tiny.replace("runs.ini", "0.1, 0.2", "0.1, 9")
    assert tiny.computed() == sorted(RUNS[:1] + MEASURED[:1])
    assert "2 points: 1 done, 1 failed." in tiny.said
    assert "Failed:\n  1 x prepare: --tau-bar 9" in tiny.said
    assert tiny.computed() == []


LINKED = ("jobs.jsonl", "sweeps/my/plan/.ninja_log") + tuple(
    f"data/{n}" for n in ("points/x.todo", "digests/load", "spare/x")
)


def test_a_link_in_the_place_of_what_it_writes_is_refused(tiny):
    (theirs := tiny.root / "theirs").mkdir()
    for name in LINKED:
        link = tiny.root / "results" / name
        link.parent.mkdir(exist_ok=True)
        link.unlink(missing_ok=True)
        link.symlink_to(theirs)
        done = tiny.sweep()
        assert (done.returncode, done.stderr.count("\n")) == (1, 1)
        assert f"results/{name} is a link, which is not followed" in done.stderr
        link.unlink()
    link.symlink_to(theirs / "file")
    with pytest.raises(OSError):
        append_to(link)
    assert not any(theirs.iterdir())


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


def test_what_ninja_says_is_said_in_our_words(capsys, folder):
    lines = NINJA.format(many="\n".join(["more"] * 40)).splitlines()
    with patch("time.monotonic", Mock(side_effect=[0, 5, 12, 30])):
        assert progress.follow(iter(lines))
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "[   5 s] 1/4 a: x 1",
        "[  30 s, about 18 s left] 1/2 b",
        "    1 of 2 points failed",
    ]
    failed, making, *more, last, error = said.err.strip().splitlines()
    assert failed == "Failed: plan what follows from these"
    assert making == "  to make: results/1.json"
    assert set(more) == {"  more"} and len(more) == 29
    assert (last, error) == ("  last", "ninja: error: no")
    assert not progress.follow(iter(["ninja: no work to do."]))


# --- by hand -----------------------------------------------------------------------------------


def test_commands_typed_by_hand_give_the_same_files(folder):
    (*_, point) = OwnSweep(ROOT / "docs/examples/driving-speed.ini").sweep.points
    typed = "\n".join(point.commands.values())
    path = {"PATH": f"{BIN}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-ec", typed], env=os.environ | path, check=True)
    (folder / "in").mkdir()
    checksums = compute_point(point.work, "in")["checksums"]
    assert checksums.keys() == {path.name for path in folder.glob("*.h5")}
    for file, checksum in checksums.items():
        assert run("analyze", "checksum", file).stdout.split() == [checksum]
