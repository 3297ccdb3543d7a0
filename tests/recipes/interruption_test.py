"""A user's sweep by ./reproduce.sh: what fails, what crashes, what is computed when the file
changes; interrupted, killed or damaged, nothing goes on by itself, and the same command completes
it (recipes/reproduce/sweeps.py)."""

import signal
from hashlib import sha256
from pathlib import Path

import pytest

from measure.tables import read_rows
from conftest import BIN, wait_for
from rupture.commands.store import BODY, head
from stand_ins import SWEEP, WITHIN, Project

# Dies like a process without memory if there is a file `die` in the project's folder.
ANALYZE = f"""case "$*" in *quantities*|*--describe*) ;; *) [ ! -e ROOT/die ] || kill -9 $$;; esac
exec {BIN}/analyze "$@"
"""
# Waits for long, unless the seed is odd or there is a file `go` in the project's folder. A file
# `edited` takes the place of the sweep's.
PREPARE = f"""case "$*" in
  *--describe*|*"seed "[13]" -o"*) exec {BIN}/prepare "$@";;
esac
[ ! -e ROOT/edited ] || cp ROOT/edited ROOT/my.ini
[ -e ROOT/go ] || {{ echo $$ >> ROOT/running; exec sleep 300; }}
exec {BIN}/prepare "$@"
"""
RUN = ("sweep", "my.ini", "--programs", "bin", "--cores", "2")


def stat_of(number):
    """State, parent and so on of a process; nothing if there is none."""
    try:
        return Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return []


class Sweep(Project):
    """Programs of its points that wait note their numbers in the file `running`."""

    def __init__(self, root):
        super().__init__(root)
        self.begun = []
        self.write("my.ini", SWEEP)
        self.link("load", "modify-phi", "parameters", "restart")
        self.program("analyze", ANALYZE.replace("ROOT", str(root)))
        self.program("prepare", PREPARE.replace("ROOT", str(root)))

    def running(self):
        """Programs of points that have not ended."""
        path = self.root / "running"
        numbers = path.read_text().split() if path.exists() else []
        return [number for number in numbers if stat_of(number)[:1] not in ([], ["Z"])]

    def go(self):
        """To the end of the sweep; what it says."""
        self.write("go")
        done = self.call(*RUN)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def started(self):
        process = self.start(*RUN)
        self.begun.append(process)
        wait_for(lambda: len(self.running()) == 2 or process.poll() is not None)
        assert process.poll() is None
        return process

    def previewed(self):
        return self.call(*RUN, "--dry-run").stdout

    def rows(self):
        return read_rows(self.root / "results/sweeps/my/my.csv")


@pytest.fixture(name="sweep")
def sweep_of_two_points(tmp_path):
    sweep = Sweep(tmp_path)
    yield sweep
    for process in sweep.begun:
        process.kill()
        process.wait()  # what it has left behind may hold its output


# --- interrupted -------------------------------------------------------------------------------


@pytest.mark.parametrize("name, code", [("SIGTERM", 143), ("SIGUSR1", 138), ("SIGHUP", 129)])
def test_a_signal_ends_all_that_runs_also_in_the_background_of_a_script(sweep, name, code):
    ignored = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        process = sweep.started()
    finally:
        signal.signal(signal.SIGINT, ignored)
    process.send_signal(signal.Signals[name])
    assert process.wait(WITHIN) == code
    assert sweep.running() == []
    assert "the same call goes on from there\n" in process.stderr.read()


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_the_same_command_goes_on_and_keeps_what_is_finished(sweep, number, code):
    """Points with an even seed wait."""
    sweep.replace("my.ini", "0.1, 0.2", "0.1\nseed = 1 to 4")
    process = sweep.started()
    second = sweep.call(*RUN)
    assert (second.returncode, second.stderr.count("\n")) == (1, 1)
    sentence = "reproduce.sh: another ./reproduce.sh is running in this folder; wait until"
    assert sentence in second.stderr
    process.send_signal(number)
    assert process.wait(WITHIN) == code
    assert "4 points: 4 done.\nComputed now: 2; already done: 2." in sweep.go()
    assert sweep.running() == []
    for old, new in (("F_T", "F"), ("F", "G")):
        sweep.replace("my.ini", f"{old} = ", f"{new} = ")
        sweep.go()
    table = (sweep.root / "results/sweeps/my/my.csv").read_bytes()
    assert sha256(table).hexdigest() in (sweep.root / "results/ro-crate-metadata.json").read_text()
    [path] = sweep.root.glob("results/store/re/*-said.json")
    body = path.read_bytes()[BODY:].replace(b"Table", b"\\u001bTable")
    path.write_bytes(head(path.stem, body) + body)
    assert "?Table: my.csv" in sweep.go()


# --- what the file says ------------------------------------------------------------------------


def test_from_a_crash_to_a_whole_table_that_grows_and_shrinks(sweep):
    sweep.write("go")
    die = sweep.write("die")
    sweep.replace("my.ini", "[sweep]", "[sweep]\ntitle = Prestress")
    sweep.replace("my.ini", "0.1, 0.2", "0.1, 2")
    done = sweep.call(*RUN)
    crash, refused = sweep.rows()
    assert (crash["status"], refused["status"]) == ("unfinished", "refused")
    assert crash["sentence"].startswith("'analyze stress start.h5 --json' ended with -9")
    assert refused["sentence"].startswith("prepare: --tau-bar 2 would put junctions beyond")
    assert done.returncode == 1
    assert "Prestress: 2 points: 0 done, 2 to compute" in done.stdout
    assert "2 points: 1 refused, 1 unfinished." in done.stdout
    assert "to retry the unfinished points, run the same command again" in done.stderr
    files = {path.name for path in (sweep.root / "results/sweeps/my").glob("*.*")}
    assert files == {f"my.{end}" for end in "ini csv png pdf".split()} | {"jobs.jsonl"}

    die.unlink()
    sweep.replace("my.ini", "0.1, 2", "0.1, 2, 0.2")
    sweep.replace("my.ini", "[quantities]", "[quantities]\np = stress.p.9\nF_N = stress.F_N")
    said = sweep.go()
    assert "3 points: 2 done, 1 refused.\nComputed now: 2; already done: 1." in said
    assert [row["F_N [N]"] for row in sweep.rows()] == ["1920.0", "", "1920.0"]
    assert sweep.rows()[0]["F_T [N]"].startswith("384.5")

    sweep.replace("my.ini", "0.1, 2, 0.2", "0.2, 0.1")
    assert sweep.previewed() == "Prestress: 2 points: 2 done, 0 to compute\n"
    assert len(sweep.rows()) == 3, "those of the table"

    sweep.replace("my.ini", "0.2, 0.1", "0.2")
    sweep.replace("my.ini", "[sweep]", "[sweep]\nthreads = 2\nmemory = 2 GB")
    process = sweep.start(*RUN)
    process.stdout.close()  # a reader who has gone
    assert (process.stderr.read(), process.wait(WITHIN)) == ("", 141)
    assert "Computed now: 0; already done: 1." in sweep.go()
    assert [row["tau-bar"] for row in sweep.rows()] == ["0.2"]
    assert (
        "Nothing to compute: all results are up to date.\n\nPrestress: 1 point: 1 done."
        in sweep.go()
    )

    for result in (sweep.root / "results/store").glob("[0-9a-f][0-9a-f]/*.json"):
        result.write_text("{")
    assert "1 point: 0 done, 1 to compute" in sweep.previewed()


# --- what points depend on ---------------------------------------------------------------------

PROFILE = """[sweep]
title = T
keep = start.h5
[commands]
prepare = prepare --profile {file} --seed {seed} -o start.h5
stress  = analyze stress start.h5
[values]
file = in/a.csv
seed = 1, 3
[quantities]
F_T = stress.F_T
"""


def test_files_of_the_user_are_found_beside_the_sweep_and_count_by_their_bytes(sweep):
    sweep.write("go")
    sweep.write("in/a.csv", "x,tau-bar\n0,0.1\n")
    sweep.write("my.ini", PROFILE)
    assert "2 points: 2 done.\nComputed now: 2" in sweep.go()
    first = sweep.rows()
    assert (sweep.root / "results" / first[0]["start.h5"]).exists()
    sweep.write("in/a.csv", "x,tau-bar\n0,0.2\n")
    assert "2 points: 0 done, 2 to compute" in sweep.previewed()
    assert "Computed now: 2" in sweep.go()
    assert [row["F_T [N]"] for row in sweep.rows()] != [row["F_T [N]"] for row in first]
    (sweep.root / "results" / sweep.rows()[1]["start.h5"]).unlink()
    assert "Computed now: 1; already done: 1." in sweep.go()
    sweep.write("other/my.ini", PROFILE.replace("in/a", "../in/a"))
    other = sweep.call("sweep", "other/my.ini", *RUN[2:]).stdout
    assert "Computed now: 0; already done: 2." in other, "the same words and bytes"
