"""The programs in the current folder: what they print, which files they change, and scripts that
make a file anew."""

import functools
import json
import os
import re
import resource
import shutil
import subprocess
import tempfile
from collections import namedtuple
from pathlib import Path

from conftest import BIN, BUILD, ROOT, SHARED

SANITIZED = re.search(r"^RUPTURE_SANITIZE:\w+=.", (BUILD / "CMakeCache.txt").read_text(), re.M)
NOBODY = 65534  # root may write everywhere
Done = namedtuple("Done", "code out err")  # minus the signal's number if one ended the program


@functools.cache
def copy_for_others():
    """The programs and the Python package in a folder that every user can enter."""
    folder = tempfile.TemporaryDirectory(dir=SHARED)
    shutil.copytree(BIN, f"{folder.name}/bin", ignore=shutil.ignore_patterns("*_test"))
    shutil.copytree(ROOT / "python", f"{folder.name}/python")
    subprocess.run(["/bin/chmod", "-R", "a+rX", folder.name], check=True)
    return folder  # exists as long as this does


def run(command, disk=None, memory=None, nobody=False, stdout=None, env=None):
    """Runs a program. Words are separated by single spaces, or given as a list. `disk` is the
    largest file [bytes], as if the disk was full then, `memory` the address space [bytes],
    `stdout` a file that takes it."""
    command = command.split(" ") if isinstance(command, str) else command
    words = [str(BIN / command[0]), *command[1:]]
    limits = {"CORE": 0, "CPU": 120, "FSIZE": disk, "AS": memory}

    def limit():
        for name, most in limits.items():
            if most is not None:
                resource.setrlimit(getattr(resource, f"RLIMIT_{name}"), (most, most))

    user: dict = {}
    if nobody and os.geteuid() == 0:
        user = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        home = copy_for_others().name
        words = [word.replace(str(BIN), f"{home}/bin") for word in words]
        env = {**(env or {}), "RUPTURE_BIN": f"{home}/bin", "PYTHONPATH": f"{home}/python"}
    with open(stdout or os.devnull, "wb") as to:
        done = subprocess.run(
            words,
            stdout=to if stdout else subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=limit,
            env=os.environ | (env or {}),
            check=False,
            **user,
        )
    out, err = (
        (text or b"").decode(errors="surrogateescape") for text in (done.stdout, done.stderr)
    )
    return Done(done.returncode, out, err)


def output_of(command):
    """What a command prints, which must succeed without complaint."""
    done = run(command)
    assert (done.code, done.err) == (0, ""), command
    return done.out


def json_of(command):
    return json.loads(output_of(command))


def lines_of(text):
    return text.removesuffix("\n").split("\n") if text else []


def checksum_of(file):
    text = output_of(["analyze", "checksum", file])
    assert re.fullmatch("[0-9a-f]{64}\n", text)
    return text.rstrip()


def is_like(text, pattern):
    """In the pattern, "..." stands for any text within a line."""
    return re.fullmatch(".*".join(map(re.escape, pattern.split("..."))), text)


def files():
    """All of the folder with their bytes; folders and links end in "/" and "@"."""
    found: dict = {}
    for folder, folders, names in os.walk("."):
        for path in (Path(folder, name) for name in folders + names):
            if path.is_symlink():
                found[f"{path}@"] = os.readlink(path)
            elif path.is_dir():
                found[f"{path}/"] = ""
            else:
                is_readable = path.is_file() and os.access(path, os.R_OK)
                found[str(path)] = path.read_bytes() if is_readable else b""
    return found


def changed(before, after):
    """Names of the files that came, went or changed."""
    return sorted(n for n in before.keys() | after.keys() if before.get(n) != after.get(n))


def name_of(tool):
    """In front of its sentences."""
    path = BIN / tool
    is_python = path.is_file() and path.read_bytes().startswith(b"#!/usr/bin/python3")
    return f"rupture {tool}" if is_python else tool


def refuses(command, code, sentence, **options):
    """With just this sentence, and all files are as before."""
    before = files()
    done = run(command, **options)
    assert (done.code, changed(before, files())) == (code, []), (command, done)
    tool = command.split(" ")[0] if isinstance(command, str) else command[0]
    assert is_like(done.err, f"{name_of(tool)}: {sentence}\n"), (command, done.err)
    return done


def script_for(file, *more):
    """Its commands from nothing."""
    return output_of(["analyze", "lineage", file, "--commands", *more])


def run_script(script):
    """As a user would in an empty folder, again, with the programs in the PATH."""
    env = {"PATH": f"{BIN}:{os.environ['PATH']}"}
    return run(["/bin/bash", "-c", f"rm -rf again; mkdir again; cd again\n{script}"], env=env)


def expect_rebuilt(file):
    """Its commands make its content; they may say which alarms they report."""
    script = script_for(file)
    done = run_script(script)
    assert done.code == 0, script
    assert not [line for line in lines_of(done.err) if ": alarm: " not in line], script
    assert checksum_of("again/rebuilt.h5") == checksum_of(file), script
