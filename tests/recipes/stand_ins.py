"""A copy of ./reproduce.sh and what it needs, in which stand-ins take the place of programs."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WITHIN = 60  # [s]
SWEEP = """[sweep]
[commands]
prepare = prepare {values} -o start.h5 --quiet
stress = analyze stress start.h5 --json
[values]
tau-bar = 0.1, 0.2
[quantities]
F_T = stress.F_T
"""


def write_program(path, text):
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


class Project(unittest.TestCase):
    """A copy of the command, with stand-ins for programs in bin/."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.bin = self.root / "bin"
        self.bin.mkdir()
        for name in ("recipes", "python"):
            shutil.copytree(ROOT / name, self.root / name)
        for name in ("reproduce.sh", "packages.txt", "CITATION.cff"):
            shutil.copy2(ROOT / name, self.root / name)

    def environment(self):
        return os.environ | {"PATH": f"{self.bin}{os.pathsep}{os.environ['PATH']}"}

    def start(self, *arguments):
        return subprocess.Popen(
            [self.root / "reproduce.sh", *arguments],
            cwd=self.root,
            env=self.environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def call(self, *arguments):
        process = self.start(*arguments)
        output, errors = process.communicate(timeout=WITHIN)
        return subprocess.CompletedProcess(arguments, process.returncode, output, errors)
