"""The names that a user's sweep may use, and their units: parameters and quantities, as `analyze
quantities` lists them, and options of the programs. Unit 1: a dimensionless number; none: a text."""

import difflib
import json
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from common.sweeps import SweepError

RECORD = ("classify", "events", "front", "loading", "slip", "slow-slip")  # what they read
CHECKPOINT = ("estimate", "phi", "strength", "stress")

WINDOW = {"from": "s", "to": "s"}
FRONT = {"slow-below": "1", "skip-below-x": "m"}
SHAPE = {"shape": "", "sigma-bar": "1"}

OPTIONS = {
    "load": {"until": "s", "record-every": "s", "seed": "1"},
    "restart": {"until": "s", "for": "s", "until-quiet": "s", "record-every": "s", "seed": "1"},
    "prepare": {**SHAPE, "tau-bar": "1", "x-trigger": "m", "tau-bar-trigger": "1", "seed": "1"},
    "modify-phi": {**SHAPE, "x-from": "m", "x-to": "m", "slipping": ""},
    "analyze classify": WINDOW | FRONT,
    "analyze events": {**FRONT, "quiet-time": "s"},
    "analyze front": WINDOW | FRONT,
    "analyze loading": {"x": "m"},
    "analyze slip": {**WINDOW, "x": "m"},
    "analyze slow-slip": {
        **WINDOW | FRONT,
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


def program_of(command):
    """Its first word, or the first two of `analyze front ...`."""
    words = command.split()
    return " ".join(words[: 2 if words[:1] == ["analyze"] else 1])


def suggestion(name, known):
    near = difflib.get_close_matches(name, known, n=1)
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
    listed = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    return Names(
        *(
            {entry["name"]: entry["unit"] for entry in listed[kind]}
            for kind in ("parameters", "quantities")
        )
    )
