"""Runs one command of a point in the point's folder."""

import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path

USER_ERRORS = (1, 2)  # exit codes with which a tool says that the request cannot be met
INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM)
UNFINISHED = "unfinished"
RUNS = ("load", "modify-phi", "prepare", "restart")  # programs that write checkpoints
PROGRAMS = ("analyze", *RUNS)


def as_run(command):
    """The words of a command with what nobody types: how it says what it found, and that FILE.sum
    is to have the checksum of each file."""
    tool, *words = shlex.split(command)
    added = ["--json"] if tool == "analyze" else ["--quiet", "--sum"] if tool in RUNS else []
    return [tool, *words, *(word for word in added if word not in words)]


def run(folder_of_tools, words, folder, files):
    """The finished command. `files`: {name in the command: file elsewhere}."""
    tool, *others = words
    arguments = [os.path.abspath(files[word]) if word in files else word for word in others]
    tools = Path(folder_of_tools).resolve()
    command: list = [tools / tool]
    if tool == "script":
        command = [sys.executable, "-P", "-m", "chains.script"]
        arguments[0] = os.path.abspath(arguments[0])
    done = subprocess.run(
        [*command, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | {"RUPTURE_BIN": str(tools)},
    )
    if -done.returncode in INTERRUPTIONS:
        sys.exit(128 - done.returncode)  # the signal was for all that runs
    return done


def fault(command, done):
    """The status of a point whose command ended so: the tool says why, or it crashed. Paths are
    those of this folder."""
    said = done.stderr.strip().replace(f"{os.getcwd()}/", "")
    if done.returncode in USER_ERRORS and not said.startswith("Traceback"):
        return {"status": "failed", "sentence": said.splitlines()[-1] if said else command}
    sentence = f"'{command}' ended with {done.returncode}{': ' if said else ''}{said}"
    return {"status": UNFINISHED, "sentence": sentence}


def checksums_in(folder):
    """{file: checksum of its content}, of what the commands have written."""
    sums = [path.read_text().split() for path in sorted(Path(folder).glob("*.sum"))]
    return {name: checksum for *_, checksum, name in sums}
