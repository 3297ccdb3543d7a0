"""A folder with stand-ins for programs, a store, and calls that use it."""

import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType

import pytest

from conftest import ROOT
from rupture import once
from rupture.commands import code

HERE = Path(__file__).parent
PROGRAMS = ("load", "prepare", "restart", "modify-phi", "analyze", "rupture")
ROOM = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # where syncing takes no time
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Laboratory:
    def __init__(self, folder):
        self.folder, self.store = folder, folder / "store"
        (folder / "bin").mkdir()
        for name in PROGRAMS:
            shutil.copy(HERE / "stand_in.sh", folder / "bin" / name).chmod(0o755)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def call(self, cores=2, **options):
        """Ends the last call and begins the next one."""
        return once.use(store=self.store, cores=cores, **{"dry_run": False} | options)

    def ran(self):
        """The commands that ran since this was asked last."""
        path = self.folder / "ran"
        lines = path.read_text().splitlines() if path.exists() else []
        path.write_text("")
        return lines

    def module(self, name, text):
        """A recipe in this folder, anew."""
        path = self.write(f"{name}.py", text)
        module = sys.modules[name] = ModuleType(name)
        module.__file__ = str(path)
        exec(compile(text, path, "exec"), module.__dict__)
        return module

    def start(self, text, *words):
        """A script of its own; it has `run` and the others."""
        once.finish()
        imports = "from rupture.once import *\nfrom rupture.once import use\nuse(cores=2)\n"
        path = self.write("script.py", imports + text)
        command, pipe = [sys.executable, path, *words], subprocess.PIPE
        return subprocess.Popen(command, cwd=self.folder, stdout=pipe, stderr=pipe, text=True)

    def script(self, text, *words):
        with self.start(text, *words) as it:
            output, said = it.communicate(timeout=60)
        return it.returncode, output, said

    def stored(self, pattern="*"):
        """{name: bytes} of what the store has."""
        return {path.name: path.read_bytes() for path in self.store.glob(f"??/{pattern}")}


@pytest.fixture
def lab(monkeypatch):
    before = [signal.signal(number, signal.SIG_DFL) for number in SIGNALS]  # nohup ignores some
    with tempfile.TemporaryDirectory(dir=ROOM) as folder:
        monkeypatch.chdir(folder)
        monkeypatch.syspath_prepend(folder)
        monkeypatch.setenv("RUPTURE_BIN", f"{folder}/bin")
        monkeypatch.setenv("PYTHONPATH", f"{ROOT}/python")
        monkeypatch.setattr(code, "BEGAN", math.inf)
        it = Laboratory(Path(folder))
        it.call()
        yield it
        once.finish()
    for number, handler in zip(SIGNALS, before):
        signal.signal(number, handler)
