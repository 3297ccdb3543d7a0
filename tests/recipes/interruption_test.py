"""A user's sweep by ./reproduce.sh: what fails, what crashes, what is computed when the file
changes; interrupted, killed or damaged, nothing goes on by itself, and the same command completes
it (recipes/{chains,reproduce}/)."""

import re
import signal
from pathlib import Path

import pytest

from conftest import BIN
from measure.tables import read_rows
from stand_ins import SWEEP, WITHIN, Project, wait_for

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
        self.link("load", "modify-phi", "restart")
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
    assert process.stderr.read().endswith("were finished before are kept\n")


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_the_same_command_goes_on_and_keeps_what_is_finished_of_a_batch(sweep, number, code):
    """Of the two points that each job computes, the second waits."""
    sweep.replace("recipes/chains/plan.py", "MOST_BATCHES = 64", "MOST_BATCHES = 2")
    sweep.replace("my.ini", "0.1, 0.2", "0.1\nseed = 1 to 4")
    process = sweep.started()
    second = sweep.call(*RUN)
    assert (second.returncode, second.stderr.count("\n")) == (1, 1)
    sentence = "reproduce.sh: another ./reproduce.sh is running in this folder; wait until"
    assert sentence in second.stderr
    assert "4 points: 2 done, 2 to compute" in sweep.previewed()
    process.send_signal(number)
    assert process.wait(WITHIN) == code
    assert "4 points: 4 done.\nComputed now: 2; already done: 2." in sweep.go()
    assert sweep.running() == []


# --- points that follow from what others report --------------------------------------------------

RUNS = """[chain]
keep = start.h5
[commands]
prepare = prepare {values} -o start.h5
stress = analyze stress start.h5
[values]
tau-bar = 0.1, 0.2
"""
FOLLOWS = """[chain]
points = runs where stress.F_T > 400
base = runs: start.h5
[commands]
run = restart {base} --for {time} -o end.h5
strength = analyze strength end.h5
[values]
time = {stress.F_T * 1e-8}
[quantities]
m = strength.mu_bar_eff.9
"""


def test_points_that_wait_for_reports_are_checked_when_these_are_there(sweep):
    sweep.write("go")
    sweep.write("runs.ini", RUNS)
    sweep.write("my.ini", FOLLOWS)
    waits = "my: its points follow from what other points report; 2 of these to"
    assert sweep.previewed().startswith(waits)
    edited = sweep.write("edited", FOLLOWS.replace("-o end.h5", "-o {time}/x"))
    done = sweep.call(*RUN)
    assert done.returncode == 2, done.stderr
    assert "-o needs the name of a file in the point's own folder" in done.stderr
    assert len(sweep.stored(".json")) == 2, "those of runs.ini"

    edited.unlink()
    sweep.write("my.ini", FOLLOWS)
    assert "1 point: 1 done.\nComputed now: 1; already done: 0." in sweep.go()
    (row,) = sweep.rows()
    assert list(row) == ["tau-bar", "time", "status", "sentence", "m", "point"]
    assert (row["tau-bar"], row["status"]) == ("0.2", "done") and float(row["time"]) > 4e-6
    assert len(sweep.stored(".json")) == 3

    sweep.replace("my.ini", "> 400", "> 4000")
    done = sweep.call(*RUN)
    sentence = "there are no points: none of runs.ini is as 'points' says"
    assert (done.returncode, sentence in done.stderr) == (2, True)


# --- what the file says ------------------------------------------------------------------------


def test_from_a_crash_to_a_whole_table_that_grows_and_shrinks(sweep):
    sweep.write("go")
    die = sweep.write("die")
    sweep.replace("my.ini", "[sweep]", "[sweep]\ntitle = Prestress")
    sweep.replace("my.ini", "0.1, 0.2", "0.1, 2")
    done = sweep.call(*RUN)
    crash, refused = sweep.rows()
    assert (crash["status"], refused["status"]) == ("unfinished", "failed")
    assert crash["sentence"] == "'analyze stress start.h5 --json' ended with -9"
    assert "Failed: my: tau-bar 0.1" in done.stderr
    assert refused["sentence"].startswith("prepare: --tau-bar 2 would put junctions beyond")
    assert done.returncode == 1
    assert "2 points: 1 failed, 1 unfinished." in done.stdout
    assert "To retry the unfinished points, run the same command again." in done.stderr
    files = {path.suffix for path in (sweep.root / "results/sweeps/my").glob("*.*")}
    assert files == {".ini", ".csv", ".hdf5", ".png", ".pdf"}
    assert re.findall(r"\] +(\d+)/(\d+) ", done.stdout)[-1] == ("2", "2")

    die.unlink()
    sweep.replace("my.ini", "0.1, 2", "0.1, 2, 0.2")
    sweep.replace("my.ini", "[quantities]", "[quantities]\np = stress.p.9\nF_N = stress.F_N")
    said = sweep.go()
    assert "3 points: 2 done, 1 failed.\nComputed now: 2; already done: 1." in said
    assert [row["F_N [N]"] for row in sweep.rows()] == ["1920.0", "", "1920.0"]
    assert sweep.rows()[0]["F_T [N]"].startswith("384.5")

    plan = (sweep.root / "results/sweeps/my/my.ini").read_text()
    sweep.replace("my.ini", "0.1, 2, 0.2", "0.2, 0.1")
    assert sweep.previewed() == "Prestress: 2 points: 2 done, 0 to compute\n"
    assert (sweep.root / "results/sweeps/my/my.ini").read_text() == plan, "that of the table"

    sweep.replace("my.ini", "0.2, 0.1", "0.2")
    sweep.replace("my.ini", "[sweep]", "[sweep]\nthreads = 2\nmemory = 2 GB")
    before = (sweep.root / "results/jobs.jsonl").read_text()
    process = sweep.start(*RUN)
    process.stdout.close()  # a reader who has gone
    assert (process.stderr.read(), process.wait(WITHIN)) == ("", 141)
    assert [row["tau-bar"] for row in sweep.rows()] == ["0.2"]
    assert (sweep.root / "results/jobs.jsonl").read_text() == before, "a point less, other needs"

    for result in sweep.stored(".json"):
        result.write_text("{")
    assert "1 point: 0 done, 1 to compute" in sweep.previewed()
