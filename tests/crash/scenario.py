"""The tools at work in small folders of their own, and what must hold of such a folder always."""

import functools
import io
import os
import re
import shlex
import subprocess
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import pytest

import conftest
from conftest import BUILD, skip

FAULTS = BUILD / "tests/libfaults.so"
if not FAULTS.exists():
    skip(f"{FAULTS} is not built")
MEMORY = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # quicker than a disk

SLIDER = "[slider]\nNx = 9\nNz = 5\nH = 0.07\n[driving]\nh = 0.0175\n"
INPUTS = {"driven.ini": (SLIDER + "V = 1\n").encode(), "rest.ini": SLIDER.encode()}
LOAD = (
    "load --config driven.ini --until 4e-4 --checkpoint-every 1.5e-4 --record r.h5"
    " --record-every 6e-7 -o b.h5"
)
PREPARE = "prepare --config rest.ini --tau-bar 0.5 -o b.h5"
TEMPORARY = re.compile(r"^\.?(.+)\.(?:tmp|kept)\.[0-9a-f]+$")


@dataclass(frozen=True)
class Scenario:
    """A command that writes the files of `new` into a folder that holds those of `old`."""

    name: str
    command: str
    old: dict = field(repr=False)
    new: dict = field(repr=False)

    def is_done(self, files):
        """Here, as pytest would print both if they differ."""
        return files == self.new


@contextmanager
def case(*words):
    """Names the case in which an assertion fails."""
    try:
        yield
    except AssertionError as error:
        raise AssertionError(f"{words}: {error}") from error


def run(command, folder, **environment):
    """Runs a tool as a user in `folder` would; returns what subprocess knows of its end."""
    options: dict = {"cwd": folder, "stdin": subprocess.DEVNULL, "timeout": 120}
    env = os.environ | {name: str(value) for name, value in environment.items()}
    return conftest.run(*shlex.split(command), env=env, **options)


def log_of(scenario):
    """The calls of a run that is left alone, one per line."""
    with Folder(scenario.old) as folder, tempfile.NamedTemporaryFile("r") as log:
        outcome = run(scenario.command, folder.path, LD_PRELOAD=FAULTS, FAULT_LOG=log.name)
        assert outcome.returncode == 0, outcome.stderr
        return log.read().splitlines()


def faulted(scenario, fault, at):
    """How the command ends with a fault at the at-th call that touches a file of its folder, and
    the files that it leaves."""
    settings = {"LD_PRELOAD": FAULTS, "FAULT": fault, "FAULT_AT": at}
    with Folder(scenario.old) as folder:
        return run(scenario.command, folder.path, **settings), folder.files()


class Folder(tempfile.TemporaryDirectory):
    """With the given files; `with Folder(files) as folder`."""

    def __init__(self, files):
        super().__init__(prefix="rupture-crash-", dir=MEMORY)
        self.path = Path(self.name)
        for name, data in files.items():
            (self.path / name).write_bytes(data)

    def __enter__(self):
        return self

    def files(self):
        return {entry.name: entry.read_bytes() for entry in self.path.iterdir()}

    def must_run(self, command):
        outcome = run(command, self.path)
        assert outcome.returncode == 0 and not outcome.stderr, f"{command}: {outcome.stderr}"
        return outcome.stdout


def without_temporaries(files):
    return {name: data for name, data in files.items() if not TEMPORARY.match(name)}


def made(name, command, old):
    """The scenario of a command. Its files are checked here: later ones need only be equal."""
    with Folder(old) as folder:
        folder.must_run(command)
        new = folder.files()
        for file in new:
            if file.endswith(".h5"):
                folder.must_run(f"analyze verify {shlex.quote(file)}")
    return Scenario(name, command, old, new)


@functools.cache
def scenarios():
    """Each way in which a tool writes, over older files of other content and without them."""
    start = "load --config driven.ini --until 2e-4 -o a.h5 -q"
    begin = made("inputs", start, INPUTS).new
    load, prepare = f"{LOAD} --force", f"{PREPARE} --force"
    empty = made("load into an empty place", load, begin)
    older = made("older files", f"{load} --seed 2", begin).new
    prepared = made("older files", f"{prepare} --seed 2 --sigma-bar 0.1", begin).new
    return [
        empty,
        made("load over older files", load, older),
        made("load resumed", f"{load} --resume", killed_late(empty)),
        made("prepare over older files", prepare, prepared),
    ]


def killed_late(scenario):
    """The folder of a run that was killed when the second of its checkpoints had got its name."""
    names = [line.split()[-1] for line in log_of(scenario)]
    moment = names.index("b-t0.000300000.h5") + 2  # calls are counted from 1
    return without_temporaries(faulted(scenario, "kill", moment)[1])


def without_notes(words):
    """What a run says apart from its progress and from checkpoints that it could not resume."""
    return re.sub(r"^(not used to resume: |\w+: +\d+ % ).+\n", "", words, flags=re.MULTILINE)


def check_files(scenario, files):
    """Holds of a folder in which the scenario's command was interrupted."""
    old, new = scenario.old, scenario.new
    for name, data in without_temporaries(files).items():
        if not name.endswith(".part"):
            assert name in new.keys() | old.keys(), f"{name} does not belong there"
            is_either = data in (old.get(name), new.get(name))
            assert is_either, f"{name} is neither the old nor the new one"
    gone = [name for name in old.keys() - files.keys() if not name.endswith(".part")]
    assert not gone, f"{gone} are gone"


def sums(files):
    """The content of a folder: the checksum that each file of ours states."""
    return {name: content_sum(data) for name, data in files.items() if name.endswith(".h5")}


def content_sum(data):
    with h5py.File(io.BytesIO(data)) as file:
        return file.attrs["content_checksum"]


def check_next_run(scenario, files):
    """Checks that the command succeeds again in a folder as it was left, and with --resume."""
    command = scenario.command.removesuffix(" --resume")
    commands = [command]
    # If the run left no trace, --resume would refuse the record of another.
    begun = "r.h5" not in scenario.old or without_temporaries(files) != scenario.old
    if begun and command.split()[0] in ("load", "restart"):
        commands.append(f"{command} --resume")
    for again in commands:
        with Folder(files) as folder:
            outcome = run(again, folder.path)
            after = without_temporaries(folder.files())
        said = without_notes(outcome.stderr)
        assert (outcome.returncode, said) == (0, ""), f"{again} fails: {outcome.stderr}"
        assert sums(after) == sums(scenario.new), f"{again} gives others: {sums(after)}"
        assert after.keys() == scenario.new.keys(), f"{again} leaves other files: {list(after)}"


def new_state(seen, files):
    """Whether a folder like this is not yet in `seen`, to which it is added."""
    state = frozenset(without_temporaries(files).items())
    new = state not in seen
    seen.add(state)
    return new


def readable_rows(files, record):
    """The samples of a record, one line each; none if the tool says why there are none."""
    with Folder({record: files[record]}) as folder:
        outcome = run(f"analyze loading {shlex.quote(record)} --csv", folder.path)
    assert re.fullmatch(r"|analyze: [^\n]+\n", outcome.stderr), outcome.stderr
    return outcome.stdout.splitlines()[1:]


def kept_in(said, files, new):
    """The names of which a message tells where their files are, for each temporary one. It is
    whole, or an empty one that could not be removed."""
    kept = [(name, found[1]) for name in files if (found := TEMPORARY.match(name))]
    for name, target in kept:
        assert name in said and files[name] in (new.get(target), b""), name
    return [target for _, target in kept]


def check_ended(scenario, outcome, files, error):
    """The command succeeded, or said in one line which file it could not write and why, and left
    the folder in order."""
    check_files(scenario, files)
    kept_in(outcome.stderr, files, scenario.new)
    if outcome.returncode == 0:
        assert scenario.is_done(files), "not all is written"
        return
    tool, said = scenario.command.split()[0], outcome.stderr
    assert outcome.returncode == 3, f"exit code {outcome.returncode}"
    assert re.fullmatch(rf"{tool}: [^\n]*{re.escape(os.strerror(error))}[^\n]*\n", said), said
    named = any(name in said for name in scenario.new)
    assert named, f"no file is named: {said!r}"


def each_scenario():
    return pytest.mark.parametrize("scenario", scenarios(), ids=lambda scenario: scenario.name)
