"""What all tests in Python share: the folders, calls of programs, and what is skipped."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BUILD = Path(os.environ.get("RUPTURE_BUILD", ROOT / "build/release"))
BIN = BUILD / "bin"
SKIPPED = 77  # as ctest knows it

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


def skip(reason):
    """All tests of a file, or the one that calls this; a failure where CI is set."""
    if os.environ.get("CI"):
        pytest.fail(f"Not checked, as it must be where CI is set: {reason}", pytrace=False)
    pytest.skip(reason, allow_module_level=True)


def need(*programs):
    if missing := [program for program in programs if not shutil.which(program)]:
        skip(f"{' and '.join(missing)} cannot be found.")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A new folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session):
    """To skip all is no success."""
    counts = session.config.pluginmanager.get_plugin("terminalreporter").stats
    if "skipped" in counts and not counts.keys() & {"passed", "failed", "error"}:
        session.exitstatus = SKIPPED
