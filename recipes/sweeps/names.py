"""The names that a user's sweep may use, and their units: parameters and quantities, as `analyze
quantities` lists them, and options of the programs. Unit 1: a dimensionless number; none: a text."""

import difflib
import json
import re
import shlex
import subprocess
from dataclasses import dataclass
from pathlib import Path

from sweeps.sweep import SweepError

KINDS = ("parameters", "quantities")
RECORD = ("classify", "events", "front", "loading", "slip", "slow-slip")  # what they read
CHECKPOINT = ("estimate", "phi", "strength", "stress")

WINDOW = {"from": "s", "to": "s"}
EVENT = {**WINDOW, "event": "", "quiet-time": "s"}
FRONT = {"slow-below": "1", "skip-below-x": "m"}
SHAPE = {"shape": "", "sigma-bar": "1"}

OPTIONS = {
    "load": {"until": "s", "record-every": "s", "seed": "1"},
    "restart": {"until": "s", "for": "s", "until-quiet": "s", "record-every": "s", "seed": "1"},
    "prepare": {**SHAPE, "tau-bar": "1", "x-trigger": "m", "tau-bar-trigger": "1", "seed": "1"},
    "modify-phi": {**SHAPE, "x-from": "m", "x-to": "m", "slipping": ""},
    "analyze classify": EVENT | FRONT,
    "analyze events": {**FRONT, "quiet-time": "s"},
    "analyze front": EVENT | FRONT,
    "analyze loading": {"x": "m"},
    "analyze slip": {**WINDOW, "x": "m"},
    "analyze slow-slip": {
        **EVENT | FRONT,
        **{"x-from": "m", "x-to": "m", "longest": "1", "shortest": "1"},
    },
    "analyze estimate": {"ensemble": "1", "seed": "1"},
    "analyze phi": {"bins": "1"},
    "analyze strength": SHAPE,
    "analyze stress": {},
    "analyze steady-state": {
        **{"v-from": "m/s", "v-to": "m/s", "points": "1", "steps-per-cycle": "1", "seed": "1"}
    },
}

ONE_NEEDED = {
    "prepare": ("tau-bar",),
    "restart": ("until", "for", "until-quiet"),
    "analyze slip": ("x",),
}


def words_of(text):
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SweepError(f"'{text}' cannot be split into words ({error})") from None


def options_in(text):
    """Names of the options in a command or a part of one, such as --until 0.5 and -o."""
    options = [re.match(r"-(?:-([a-z][a-z-]*)|([a-z]))", word) for word in words_of(text)]
    return [match[1] or match[2] for match in options if match]


def parameters_in(text):
    """Names of the parameters that a command sets."""
    return re.findall(r"(?:^| )--set[ =](\S+?)=", " ".join(words_of(text)))


def setting(name):
    """What an option or a parameter sets: `--seed 1` is short for `--set numerics.seed=1`."""
    return "numerics.seed" if name == "seed" else name


def options_of(program, tools):
    """The names in its --help."""
    if program not in OPTIONS:
        raise SweepError(f"there is no program '{program}'{suggestion(program, OPTIONS)}")
    tool, *command = program.split()
    help_of = [Path(tools) / tool, *command, "--help"]
    done = subprocess.run(help_of, capture_output=True, check=False, text=True)
    if done.returncode:
        raise SweepError(
            f"'{program} --help' ended with {done.returncode}: the program cannot be used"
        )
    return [
        long or short for long, short in re.findall(r"--([a-z][a-z-]*)|\s-([a-z])\b", done.stdout)
    ]


def program_of(command):
    """Its first word, or the first two of `analyze front ...`."""
    words = command.split()
    return " ".join(words[: 2 if words[:1] == ["analyze"] else 1])


def suggestion(name, known):
    """Rather a name that differs in capitals only than a similar one."""
    same = [other for other in known if other.lower() == name.lower()]
    near = [*same, *difflib.get_close_matches(name, known, n=1)]
    return f"; did you mean '{near[0]}'?" if near else ""


@dataclass(frozen=True)
class Names:
    parameters: dict  # name: unit
    quantities: dict  # name: unit; * stands for an index

    def quantity_unit(self, name, of_file):
        """`analyze strength` reports numbers of a shape, but lists of a file."""
        keys = ["*" if re.fullmatch(r"-?\d+", key) else key for key in name.split(".")]
        pattern = ".".join(keys)
        is_list = f"{pattern}.*" in self.quantities
        if pattern in self.quantities and not (is_list and of_file):
            return self.quantities[pattern]
        if is_list:
            raise SweepError(f"'{name}' is a list: name one of its elements, as in {name}.0")
        raise SweepError(
            f"analyze reports no '{name}'{suggestion(pattern, self.quantities)}"
            " (`analyze quantities` lists what there is)"
        )

    def value_unit(self, name, programs):
        """Of a parameter, or of an option that all these programs have."""
        if "." in name:
            if name not in self.parameters:
                raise SweepError(
                    f"there is no parameter '{name}'{suggestion(name, self.parameters)}"
                )
            return self.parameters[name]
        for program in programs:
            if name not in OPTIONS.get(program, {}):
                known = [*OPTIONS.get(program, {}), *self.parameters]
                raise SweepError(
                    f"{program} has no option '{name}' that takes a value"
                    f"{suggestion(name, known)} (the name of a parameter has a dot)"
                )
        return OPTIONS[programs[0]][name]


def names_of(folder_of_tools):
    """As the programs in this folder have them."""
    command = [Path(folder_of_tools) / "analyze", "quantities", "--json"]
    done = subprocess.run(command, capture_output=True, check=False)
    if done.returncode:
        raise SweepError(f"{command[0]} is too old for sweeps: it has no command 'quantities'")
    listed = json.loads(done.stdout)
    units = [{entry["name"]: entry["unit"] for entry in listed[kind]} for kind in KINDS]
    return Names(*units)
