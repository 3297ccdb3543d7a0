"""A user's sweep by ./reproduce.sh: what fails, what crashes, what is computed when the file
changes; interrupted, killed or damaged, nothing goes on by itself, and the same command completes
it (recipes/{chains,reproduce}/)."""

import os
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
# Waits for long, unless there is a file `go` in the project's folder.
PREPARE = f"""case "$*" in
  *--describe*) ;;
  *) echo $$ >> ROOT/running; [ -e ROOT/go ] || exec sleep 300;;
esac
exec {BIN}/prepare "$@"
"""
SECOND_WAITS = f"""case "$*" in
  *--describe*|*"seed "*[13579]" -o"*) ;;
  *) [ -e ROOT/go ] || {{ echo $$ >> ROOT/running; exec sleep 300; }};;
esac
exec {BIN}/prepare "$@"
"""


def stat_of(number):
    """State, parent and so on of a process; nothing if there is none."""
    try:
        return Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return []


class Sweep(Project):
    """Programs of its points note their numbers in the file `running`."""

    def __init__(self, root):
        super().__init__(root)
        self.begun = []
        self.write("my.ini", SWEEP)
        for tool in ("load", "modify-phi", "restart"):
            (self.bin / tool).symlink_to(BIN / tool)
        self.program("analyze", ANALYZE.replace("ROOT", str(root)))
        self.program("prepare", PREPARE.replace("ROOT", str(root)))

    def running(self):
        """Programs of points that have not ended."""
        path = self.root / "running"
        numbers = path.read_text().split() if path.exists() else []
        return [number for number in numbers if stat_of(number)[:1] not in ([], ["Z"])]

    def begin(self):
        return self.start("sweep", "my.ini", "--programs", "bin", "--cores", "2")

    def go(self):
        """To the end of the sweep."""
        self.write("go")
        done = self.call("sweep", "my.ini", "--programs", "bin")
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def started(self):
        process = self.begin()
        self.begun.append(process)
        wait_for(lambda: len(self.running()) == 2 or process.poll() is not None)
        assert process.poll() is None
        return process


@pytest.fixture(name="sweep")
def sweep_of_two_points(tmp_path):
    sweep = Sweep(tmp_path)
    yield sweep
    for process in sweep.begun:
        process.kill()
        process.wait()  # what it has left behind may hold its output


@pytest.mark.parametrize("name, code", [("SIGINT", 130), ("SIGUSR1", 138), ("SIGHUP", 129)])
def test_a_signal_ends_all_that_runs(sweep, name, code):
    process = sweep.started()
    process.send_signal(signal.Signals[name])
    assert process.wait(WITHIN) == code
    assert sweep.running() == []
    assert process.stderr.read().endswith("were finished before are kept\n")


def test_a_signal_ends_what_was_started_in_the_background_of_a_script(sweep):
    ignored = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        process = sweep.started()
    finally:
        signal.signal(signal.SIGINT, ignored)
    process.terminate()
    assert process.wait(WITHIN) == 143
    assert sweep.running() == []


def test_a_reader_that_has_gone_does_not_stop_it(sweep):
    sweep.write("go")
    process = sweep.begin()
    process.stdout.close()
    process.stderr.read()
    assert process.wait(WITHIN) == 141
    assert len(list((sweep.root / "results/data/points").glob("*.json"))) == 2
    assert (sweep.root / "results/sweeps/my/my.csv").exists()


def test_a_damaged_result_is_computed_again(sweep):
    sweep.go()
    next((sweep.root / "results/data/points").glob("*.json")).write_text("{")
    preview = sweep.call("sweep", "my.ini", "--programs", "bin", "--dry-run").stdout
    assert "2 points: 1 done, 1 to compute\n" in preview
    assert "2 points: 2 done.\nComputed now: 1; already done: 1." in sweep.go()


def test_a_second_run_is_refused_while_the_first_one_runs(sweep):
    sweep.started()
    done = sweep.call("sweep", "my.ini", "--programs", "bin")
    assert (done.returncode, done.stderr.count("\n")) == (1, 1)
    sentence = "reproduce.sh: another ./reproduce.sh is running in this folder; wait until"
    assert sentence in done.stderr
    assert "2 to compute" in sweep.call("sweep", "my.ini", "--programs", "bin", "--dry-run").stdout


def test_what_a_killed_run_leaves_behind_ends_and_the_same_command_goes_on(sweep):
    process = sweep.started()
    process.kill()
    process.wait()
    assert "2 points: 2 done." in sweep.go()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_what_is_finished_of_a_batch_is_kept(sweep, number):
    """Of each two points that one job computes, the second waits for long."""
    sweep.program("prepare", SECOND_WAITS.replace("ROOT", str(sweep.root)))
    sweep.write("my.ini", SWEEP.replace("0.1, 0.2", "0.1\nseed = 1 to 100"))
    process = sweep.begin()
    sweep.begun.append(process)
    wait_for(lambda: len(sweep.running()) == 2)
    process.send_signal(number)
    process.wait(WITHIN)
    wait_for(lambda: not sweep.running())
    assert "Computed now: 98; already done: 2." in sweep.go()
    assert len(list((sweep.root / "results/data/points").glob("*.json"))) == 100


def test_what_follows_ninja_alone_may_be_killed(sweep):
    process = sweep.started()
    (progress,) = [
        int(folder.name)
        for folder in Path("/proc").glob("[0-9]*")
        if stat_of(folder.name)[1:2] == [str(process.pid)]
        and b"chains.progress" in (folder / "cmdline").read_bytes()
    ]
    os.kill(progress, signal.SIGKILL)
    assert process.wait(WITHIN) == 1
    wait_for(lambda: not sweep.running())


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
EDIT = f"""case "$*" in
  *--describe*) ;;
  *) [ ! -e ROOT/edited ] || cp ROOT/edited ROOT/my.ini;;
esac
exec {BIN}/prepare "$@"
"""


def test_points_that_wait_for_reports(sweep):
    sweep.write("runs.ini", RUNS)
    sweep.write("my.ini", FOLLOWS)
    said = sweep.call("sweep", "my.ini", "--programs", "bin", "--dry-run").stdout
    assert said.startswith("my: its points follow from what other points report; 2 of these to")
    assert "1 point: 1 done.\nComputed now: 1; already done: 0." in sweep.go()
    (row,) = read_rows(sweep.root / "results/sweeps/my/my.csv")
    assert list(row) == ["tau-bar", "time", "status", "sentence", "m", "point"]
    assert (row["tau-bar"], row["status"]) == ("0.2", "done") and float(row["time"]) > 4e-6
    said = sweep.call("sweep", "my.ini", "--programs", "bin", "--dry-run").stdout
    assert said == "my: 1 point: 1 done, 0 to compute\n"


@pytest.mark.parametrize(
    "old, new, sentence",
    [
        ("restart {base}", "script x.py", "line 5: there is no program 'script'"),
        ("-o end.h5", "-o {time}/x", "-o needs the name of a file in the point's own folder"),
        ("> 400", "> 4000", "there are no points: none of runs.ini is as 'points' says"),
    ],
)
def test_a_file_that_changes_during_the_run_is_checked_again(sweep, old, new, sentence):
    sweep.program("prepare", EDIT.replace("ROOT", str(sweep.root)))
    sweep.write("runs.ini", RUNS)
    sweep.write("my.ini", FOLLOWS)
    sweep.write("edited", FOLLOWS.replace(old, new))
    done = sweep.call("sweep", "my.ini", "--programs", "bin")
    assert (done.returncode, sentence in done.stderr) == (2, True), done.stderr
    assert len(list((sweep.root / "results/data/points").glob("*.json"))) == 2


# --- what the file says ------------------------------------------------------------------------


def compute(sweep, values, quantities="", needs=""):
    """The finished command, and how many points it has computed."""
    text = SWEEP.replace("[sweep]", f"[sweep]\ntitle = Prestress\n{needs}") + quantities
    sweep.write("my.ini", text.replace("0.1, 0.2", values))
    done = sweep.call("sweep", "my.ini", "--programs", "bin")
    return done, int(re.findall(r"Computed now: (\d+);", done.stdout)[0])


def test_from_a_crash_to_a_whole_table_that_grows_and_shrinks(sweep):
    def rows():
        return read_rows(sweep.root / "results/sweeps/my/my.csv")

    sweep.write("go")
    die = sweep.write("die")
    crashed, _ = compute(sweep, "0.1, 2")
    crash, refused = rows()
    assert (crash["status"], refused["status"]) == ("unfinished", "failed")
    assert re.match("'analyze stress start.h5 --json' ended with -9$", crash["sentence"])
    assert "Failed: my: tau-bar 0.1" in crashed.stderr
    assert refused["sentence"].startswith("prepare: --tau-bar 2 would put junctions beyond")
    assert crashed.returncode == 1
    assert "2 points: 1 failed, 1 unfinished." in crashed.stdout
    assert "To retry the unfinished points, run the same command again." in crashed.stderr
    files = {path.suffix for path in (sweep.root / "results/sweeps/my").glob("*.*")}
    assert files == {".ini", ".csv", ".hdf5", ".png", ".pdf"}
    assert re.findall(r"\] +(\d+)/(\d+) ", crashed.stdout)[-1] == ("2", "2")

    die.unlink()
    again, _ = compute(sweep, "0.1, 2")
    assert (again.returncode, again.stderr) == (0, "")
    assert "2 points: 1 done, 1 failed.\nComputed now: 1; already done: 1." in again.stdout
    assert rows()[0]["F_T [N]"].startswith("384.5")

    _, computed = compute(sweep, "0.1, 2, 0.2", "p = stress.p.9\nF_N = stress.F_N\n")
    assert computed == 1, "of a new value and new quantities, only the value"
    assert [row["F_N [N]"] for row in rows()] == ["1920.0", "", "1920.0"]

    compute(sweep, "0.2")
    plan = (sweep.root / "results/sweeps/my/my.ini").read_text()
    sweep.write("my.ini", (sweep.root / "my.ini").read_text().replace("0.2", "0.2, 0.1"))
    said = sweep.call("sweep", "my.ini", "--programs", "bin", "--dry-run").stdout
    assert said == "Prestress: 2 points: 2 done, 0 to compute\n"
    assert (sweep.root / "results/sweeps/my/my.ini").read_text() == plan, "that of the table"

    last, computed = compute(sweep, "0.2", needs="threads = 2\nmemory = 2 GB")
    assert computed == 0, "a point less, and other needs"
    assert [row["tau-bar"] for row in rows()] == ["0.2"]
    assert "Computed now: 0; already done: 1." in last.stdout
