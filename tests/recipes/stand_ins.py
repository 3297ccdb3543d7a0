"""A copy of ./reproduce.sh and what it needs, in which stand-ins take the place of programs."""

import os
import shutil
import subprocess
from pathlib import Path

from conftest import BIN, ROOT

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


class Project:
    """The stand-ins are in bin/, first on the PATH."""

    within = WITHIN

    def __init__(self, root, environment=os.environ):
        self.root, self.bin = root, root / "bin"
        self.environment = environment  # when a program starts
        self.program("apt-get", "")  # nothing is missing
        for name in ("recipes", "python"):
            shutil.copytree(ROOT / name, root / name)
        for script in root.rglob("*.sh"):
            script.chmod(0o644)  # as some archives unpack it
        for name in ("reproduce.sh", "packages.txt", "CITATION.cff"):
            shutil.copy2(ROOT / name, root / name)

    def program(self, name, text):
        """In bash; `name` may lead to another folder."""
        self.write(self.bin / name, f"#!/bin/bash\n{text}\n").chmod(0o755)

    def link(self, *names):
        """The programs themselves."""
        for name in names:
            (self.bin / name).symlink_to(BIN / name)

    def start(self, *words, command="./reproduce.sh", stderr=subprocess.PIPE, **options):
        return subprocess.Popen(
            [command, *words],
            cwd=self.root,
            env=self.environment | {"PATH": f"{self.bin}:{self.environment['PATH']}"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=stderr,
            text=True,
            **options,
        )

    def call(self, *words, **options):
        process = self.start(*words, **options)
        output, errors = process.communicate(timeout=self.within)
        return subprocess.CompletedProcess(words, process.returncode, output, errors)

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def replace(self, name, old, new):
        text = (self.root / name).read_text()
        assert old in text
        self.write(name, text.replace(old, new, 1))

    def calls(self):
        """What stand-ins have written of themselves."""
        return Path(self.root / "calls").read_text()
