#!/usr/bin/env python3
"""Computes one point of a sweep (sweeps.py): point.py FOLDER_OF_TOOLS OUTPUT BASE NAME=COMMAND...

The commands run one after the other in an empty folder, which is deleted at the end. BASE is the
file from outside that they read, or empty. OUTPUT is a JSON file with the commands, the checksum of
every file that they wrote, what those with --json reported, under their names, and a status: done,
or failed with the tool's sentence.
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


def run(folder_of_tools, command, base, folder):
    """The command's output."""
    tool, *arguments = shlex.split(command)
    arguments = [os.path.abspath(base) if a == base else a for a in arguments]
    done = subprocess.run(
        [Path(folder_of_tools).resolve() / tool, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode not in (0, *USER_ERRORS):
        code = done.returncode
        print(f"point.py: '{command}' ended with {code}: {done.stderr.strip()}", file=sys.stderr)
        sys.exit(128 - code if code < 0 else code)  # of a signal, as a shell says it
    return done


def checksums(folder):
    """Content checksums, as the tools write them beside their files."""
    lines = [path.read_text().split() for path in sorted(Path(folder).glob("*.sum"))]
    return {name: checksum for checksum, name in lines}


def compute(folder_of_tools, base, commands):
    point = {"commands": list(commands.values()), "status": "done", "sentence": ""}
    with tempfile.TemporaryDirectory(prefix="rupture-point-") as folder:
        for name, command in commands.items():
            done = run(folder_of_tools, command, base, folder)
            if done.returncode:
                sentence = done.stderr.strip().splitlines()
                point |= {"status": "failed", "sentence": sentence[-1] if sentence else command}
                break
            if "--json" in shlex.split(command):
                point[name] = json.loads(done.stdout)
        point["checksums"] = checksums(folder)
    return point


def main(folder_of_tools, output, base, *commands):
    for number in (signal.SIGINT, signal.SIGTERM):  # so that the folder is deleted
        signal.signal(number, lambda which, _: sys.exit(128 + which))
    point = compute(folder_of_tools, base, dict(command.split("=", 1) for command in commands))
    temporary = Path(f"{output}.part")
    temporary.write_text(json.dumps(point) + "\n", encoding="utf-8")
    os.replace(temporary, output)


if __name__ == "__main__":
    main(*sys.argv[1:])
