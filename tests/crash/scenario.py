"""The tools at work in small folders of their own, and what must hold of such a folder always."""

import functools
import os
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from conftest import BIN, BUILD, skip

FAULTS = BUILD / "tests/libfaults.so"
LONG = "RUPTURE_CRASH_LONG" in os.environ
if not FAULTS.exists():
    skip(f"{FAULTS} is not built")
MEMORY = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # quicker than a disk

SLIDER = "[slider]\nNx = 9\nNz = 5\nH = 0.07\n[driving]\nh = 0.0175\n"
INPUTS = {"driven.ini": (SLIDER + "V = 1\n").encode(), "rest.ini": SLIDER.encode()}
TEMPORARY = re.compile(r"^\.(.+)\.tmp\.[0-9a-f]+$")


@dataclass(frozen=True)
class Scenario:
    """A command that writes the files of `new` into a folder that holds those of `old`."""

    name: str
    command: str
    old: dict = field(repr=False)
    new: dict = field(repr=False)

    def outputs(self):
        return {name for name in self.new if self.new[name] != self.old.get(name)}


def run(command, folder, options=None, **environment):
    """Runs a tool as a user in `folder` would; returns what subprocess knows of its end."""
    words = command.split()
    return subprocess.run(
        [BIN / words[0], *words[1:]],
        cwd=folder,
        env={**os.environ, **{name: str(value) for name, value in environment.items()}},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        **(options or {}),
    )


def run_with_fault(command, folder, fault="", at=0, log=""):
    """The same with the fault at the at-th call that touches a file of the folder."""
    settings = {"FAULT": fault, "FAULT_AT": at} if fault else {}
    if log:
        settings["FAULT_LOG"] = log
    return run(command, folder, LD_PRELOAD=FAULTS, **settings)


def log_of(scenario):
    """The calls of a run that is left alone, one per line."""
    with Folder(scenario.old) as folder, tempfile.NamedTemporaryFile("r") as log:
        outcome = run_with_fault(scenario.command, folder.path, log=log.name)
        assert outcome.returncode == 0, outcome.stderr
        return log.read().splitlines()


class Folder:
    """A temporary folder with the given files; `with Folder(files) as folder`."""

    def __init__(self, files):
        self.path = Path(tempfile.mkdtemp(prefix="rupture-crash-", dir=MEMORY))
        for name, data in files.items():
            (self.path / name).write_bytes(data)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.path)

    def files(self):
        return {entry.name: entry.read_bytes() for entry in self.path.iterdir()}

    def must_run(self, command):
        outcome = run(command, self.path)
        assert outcome.returncode == 0 and not outcome.stderr, f"{command}: {outcome.stderr}"
        return outcome.stdout


def is_part(name):
    return name.endswith(".part")


def without_temporaries(files):
    return {name: data for name, data in files.items() if not TEMPORARY.match(name)}


def made(name, command, old):
    """The scenario of a command. Its files are checked here: later ones need only be equal."""
    with Folder(old) as folder:
        folder.must_run(command)
        new = folder.files()
        for file in new:
            if file.endswith(".h5"):
                folder.must_run(f"analyze verify {file}")
                content = folder.must_run(f"analyze checksum {file}").strip()
                line = f"content-sha256 {content}  {file}\n".encode()
                kept = new[file] == old.get(file)
                wanted = kept or "--sum" in command.split()
                assert new.get(file + ".sum") == (line if wanted else None)
    return Scenario(name, command, old, new)


@functools.cache
def scenarios():
    """Every tool that writes, over older files of other content and without them."""
    start = "load --config driven.ini --until 2e-4 -o a.h5 -q --sum"
    begin = made("inputs", start, INPUTS).new
    run_options = "--record r.h5 --record-every 6e-7 -o b.h5 --force --sum"
    load = f"load --config driven.ini --until 4e-4 --checkpoint-every 1.5e-4 {run_options}"
    restart = f"restart a.h5 --for 3e-4 --checkpoint-at 4e-4 {run_options}"
    prepare = "prepare --config rest.ini --tau-bar 0.5 -o b.h5 --force --sum"
    modify = "modify-phi a.h5 -o b.h5 --force --sum"
    other = {
        "load": f"{load} --seed 2",
        "restart": f"{restart} --set driving.V=2",
        "prepare": f"{prepare} --seed 2 --sigma-bar 0.1",
        "modify-phi": f"{modify} --sigma-bar 0.1",
    }
    result = []
    for command in (load, restart, prepare, modify):
        tool = command.split()[0]
        result.append(made(f"{tool} into an empty place", command, begin))
        older = made(tool, other[tool], begin).new
        result.append(made(f"{tool} over older files", command, older))
        if tool == "load":  # which leaves no sum of another file behind
            without = command.replace(" --sum", "")
            result.append(made("load over older files, without sums", without, older))
    result.append(made("load resumed", f"{load} --resume", killed_late(result[0])))
    return result


def killed_late(scenario):
    """The folder of a run that was killed when the second of its checkpoints had got its name."""
    names = [line.split()[-1] for line in log_of(scenario)]
    with Folder(scenario.old) as folder:
        moment = names.index("b-t0.000300000.h5") + 2  # calls are counted from 1
        run_with_fault(scenario.command, folder.path, "kill", moment)
        return without_temporaries(folder.files())


def without_notes(words):
    """What a run says apart from its progress and from checkpoints that it could not resume."""
    return re.sub(r"^(not used to resume: |\w+: +\d+ % ).+\n", "", words, flags=re.MULTILINE)


def faults_in_files(scenario, files):
    """The faults of a folder in which the scenario's command was interrupted."""
    faults = []
    for name, data in sorted(without_temporaries(files).items()):
        if is_part(name):
            continue
        if name not in scenario.new.keys() | scenario.old.keys():
            faults.append(f"{name} does not belong there")
        elif name.endswith(".sum"):
            if not sum_agrees(scenario, name, files):
                faults.append(f"{name} disagrees with its file")
        elif data not in (scenario.old.get(name), scenario.new.get(name)):
            faults.append(f"{name} is neither the old nor the new one")
    for name in scenario.old:
        if name not in files and not name.endswith((".sum", ".part")):
            faults.append(f"{name} is gone")
    return faults


def sum_agrees(scenario, name, files):
    content = files.get(name.removesuffix(".sum"))
    return any(
        content is not None
        and content == version.get(name.removesuffix(".sum"))
        and files[name] == version.get(name)
        for version in (scenario.old, scenario.new)
    )


def sums(files):
    """The content of a folder: the checksum of each file of ours."""
    return {name: data for name, data in files.items() if name.endswith(".sum")}


def begun(scenario, files):
    """Whether the run has left a trace; with none, --resume would refuse the record of another."""
    return "r.h5" not in scenario.old or without_temporaries(files) != scenario.old


def faults_of_next_run(scenario, files):
    """Faults if the same command is given again in a folder as it was left, or resumed."""
    command = scenario.command.removesuffix(" --resume")
    again = [command]
    if begun(scenario, files) and command.split()[0] in ("load", "restart"):
        again.append(f"{command} --resume")
    return [fault for command in again for fault in faults_of_run(command, scenario, files)]


def faults_of_run(command, scenario, files):
    with Folder(files) as folder:
        outcome = run(command, folder.path)
        if outcome.returncode != 0 or without_notes(outcome.stderr):
            return [f"{command} fails: {outcome.stderr.strip()}"]
        after = without_temporaries(folder.files())
    faults = []
    if sums(after) != sums(scenario.new):
        faults.append(f"{command} gives others: {sums(after)}")
    if after.keys() != scenario.new.keys():
        faults.append(f"{command} leaves other files: {after.keys() ^ scenario.new.keys()}")
    return faults


def new_state(seen, files):
    """Whether a folder like this is not yet in `seen`, to which it is added."""
    state = frozenset(without_temporaries(files).items())
    new = state not in seen
    seen.add(state)
    return new


def readable_rows(folder, record):
    """The samples of a record, one line each; none if the tool says why there are none."""
    outcome = run(f"analyze loading {record} --csv", folder)
    assert re.fullmatch(r"|analyze: [^\n]+\n", outcome.stderr), outcome.stderr
    return outcome.stdout.splitlines()[1:]


def faults_of_failure(outcome, reason, scenario):
    """A tool that failed says so in one line: which file, and why."""
    faults = []
    if outcome.returncode != 1:
        faults.append(f"exit code {outcome.returncode}")
    tool = scenario.command.split()[0]
    if not re.fullmatch(rf"{tool}: [^\n]+\n", outcome.stderr):
        faults.append(f"not one sentence: {outcome.stderr!r}")
    if reason not in outcome.stderr:
        faults.append(f"'{reason}' is not said: {outcome.stderr!r}")
    if not any(name.removesuffix(".sum") in outcome.stderr for name in scenario.new):
        faults.append(f"no file is named: {outcome.stderr!r}")
    return faults
