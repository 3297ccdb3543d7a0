"""What all tests in Python share: the folders, calls of programs, and what is skipped."""

import contextlib
import functools
import importlib.util
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("RUPTURE_BUILD", ROOT / "build/release"))
BIN = BUILD / "bin"
SMALL = ROOT / "tests/golden/small.ini"
SHARED = "/tmp"  # where every user can enter new folders, unlike in pytest's, or perhaps in $TMPDIR
ODD = 'Jørgen\'s "copy" (v2) {new}'  # a name of a folder
SKIPPED = 77  # as ctest knows it
approx = functools.partial(pytest.approx, rel=0, abs=5e-8)

os.environ |= {
    "RUPTURE_BIN": str(BIN),
    "PYTHONPATH": f"{ROOT}/python",
    "PYTHONDONTWRITEBYTECODE": "1",
    "MPLBACKEND": "Agg",
}


def run(program, *words, **options):
    """A finished program and what it printed; one that has no path is ours."""
    command = [BIN / program if (BIN / program).exists() else program, *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


def succeeds(program, *words, **options):
    done = run(program, *words, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


def tools_described():
    """What all programs say of themselves."""
    listed = json.loads(run("rupture", "--describe").stdout)["tools"]
    return [one | json.loads(run(one["name"], "--describe").stdout) for one in listed]


def started(command, part, pieces=0, **options):
    """A run whose unfinished record is there, and has at least this many pieces."""
    it, end = subprocess.Popen(command, **options), time.monotonic() + 60
    while not part.exists() or part.read_bytes().count(b"rupture-record-part\n") < pieces:
        assert it.poll() is None, "the run ended before that"
        assert time.monotonic() < end, "the run takes too long"
        time.sleep(0.001)
    return it


def wait_for(condition, within=60):
    """For so many seconds at most; what it finds."""
    end = time.monotonic() + within
    while not (met := condition()):
        assert time.monotonic() < end
        time.sleep(0.01)
    return met


@contextlib.contextmanager
def stopped(process):
    """It stands still within, all threads of it, and goes on afterwards."""
    process.send_signal(signal.SIGSTOP)
    os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)


def draws(name, *arguments, **options):
    """Whether a program of the package succeeds and only says what it wrote."""
    done = run(name, *arguments, **options)
    output = Path(arguments[arguments.index("-o") + 1])
    written = [output.with_name(f"{output.stem}-derived.hdf5")] if name == "xdmf" else []
    said = "".join(f"wrote {path}\n" for path in (*written, output))
    assert (done.returncode, done.stdout, done.stderr) == (0, said, "")


def skip(reason):
    """All tests of a file, or the one that calls this; a failure where CI is set."""
    if os.environ.get("CI"):
        pytest.fail(f"Not checked, as it must be where CI is set: {reason}", pytrace=False)
    pytest.skip(reason, allow_module_level=True)


def need_modules(*names):
    for name in names:
        if not importlib.util.find_spec(name):
            skip(f"Python has no module {name}.")


def need_simulation():
    from rupture import Failure, simulation

    try:
        simulation.module()
    except Failure as why:
        skip(f"{why}.")


def need(*programs):
    if missing := [program for program in programs if not shutil.which(program)]:
        skip(f"{' and '.join(missing)} cannot be found.")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A new folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def small_ini(monkeypatch):
    """A new folder, which is the current one and which other users can be let into, with small.ini:
    a slider of 9 x 5 blocks that is driven so fast that a rupture crosses it from t = 0.15 ms to
    0.25 ms."""
    slider = "[slider]\nNx = 9\nNz = 5\nH = 0.07\n[driving]\nh = 0.0175\nV = 1\n"
    with tempfile.TemporaryDirectory(dir=SHARED) as folder:
        monkeypatch.chdir(folder)
        Path("small.ini").write_text(slider)
        yield


@pytest.fixture(scope="session")
def run_of_small(tmp_path_factory):
    """small.h5 and small-record.h5 of a small slider, through which a rupture passes."""
    import rupture

    folder = tmp_path_factory.mktemp("small")
    files = {"output": folder / "small.h5", "record": folder / "small-record.h5"}
    times = {"until": 0.002, "record_every": 2e-6, "checkpoint_every": 5e-4}
    return rupture.run("load", **files, **times, config=SMALL)


@pytest.fixture
def small(run_of_small, folder):
    """The same, copied to the current folder."""
    shutil.copytree(run_of_small.output.parent, folder, dirs_exist_ok=True)
    return type(run_of_small)(folder / "small.h5", folder / "small-record.h5")


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session):
    """To skip all is no success."""
    counts = session.config.pluginmanager.get_plugin("terminalreporter").stats
    if "skipped" in counts and not counts.keys() & {"passed", "failed", "error"}:
        session.exitstatus = SKIPPED
