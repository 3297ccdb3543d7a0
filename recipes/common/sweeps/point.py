"""Computes one point of a sweep (sweep.py).

Its commands run one after the other in an empty folder, which is deleted at the end. The result has
the commands, the checksum of every file that they wrote, what those with --json reported, under
their names, and a status: done, or failed with the tool's sentence.
"""

import json
import os
import shlex
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

USER_ERRORS = (1, 2)  # exit codes with which a tool says that the request cannot be met
INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM)
WRITERS = ("load", "modify-phi", "prepare", "restart")


class Crash(Exception):
    """A program ended without an exit code that is a tool's own."""


def arguments_of(command, base):
    """The base is a path from anywhere. Programs that write files note their checksums, too."""
    words = [os.path.abspath(word) if word == base else word for word in shlex.split(command)]
    asks_for_sum = words[0] in WRITERS and "--sum" not in words
    return [*words, "--sum"] if asks_for_sum else words


def run(folder_of_tools, command, base, folder):
    """The finished command. Raises Crash."""
    tool, *arguments = arguments_of(command, base)
    done = subprocess.run(
        [Path(folder_of_tools).resolve() / tool, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    if -done.returncode in INTERRUPTIONS:
        sys.exit(128 - done.returncode)  # the signal was for all that runs
    if done.returncode not in (0, *USER_ERRORS):
        said = done.stderr.strip()
        raise Crash(f"'{command}' ended with {done.returncode}{': ' if said else ''}{said}")
    return done


def checksums(folder):
    """Content checksums, as the tools write them beside their files."""
    lines = [path.read_text().split() for path in sorted(Path(folder).glob("*.sum"))]
    return {name: checksum for *_, checksum, name in lines}


def compute(folder_of_tools, point):
    """The result of a point. Raises Crash."""
    result = {"commands": list(point.commands.values()), "status": "done", "sentence": ""}
    with tempfile.TemporaryDirectory(prefix="rupture-point-") as folder:
        for name, command in point.commands.items():
            done = run(folder_of_tools, command, point.base, folder)
            if done.returncode:
                sentence = done.stderr.strip().splitlines()
                result |= {"status": "failed", "sentence": sentence[-1] if sentence else command}
                break
            if "--json" in shlex.split(command):
                result[name] = json.loads(done.stdout)
        result["checksums"] = checksums(folder)
    return result
