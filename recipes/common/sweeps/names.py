"""The names that a user's sweep may use, and their units: parameters and quantities, as `analyze
quantities` lists them, and options, as the programs describe them. Unit 1: a dimensionless number;
none: a text."""

import difflib
import json
import re
import shlex
import subprocess
from dataclasses import dataclass
from pathlib import Path

from sweeps.sweep import SweepError

KINDS = ("parameters", "quantities")
TOOLS = ("load", "prepare", "restart", "modify-phi", "analyze")
VARIABLE = ("number", "integer", "choice", "text")  # kinds of values; others are files and flags


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
    """The parameter or option that is set: `--seed 1` is short for `--set numerics.seed=1`."""
    return "numerics.seed" if name == "seed" else name


@dataclass(frozen=True)
class Program:
    """One of TOOLS, or a command of `analyze`, as it describes itself."""

    long_names: dict  # of all options, by their long and short names
    units: dict  # of the options that may vary
    one_needed: list  # groups of options, of each of which one must be given
    input: str  # "checkpoint", "record", "file" or None


def program_from(description):
    options = description["options"]
    names = {option["short"]: option["name"] for option in options if option["short"]}
    return Program(
        names | {option["name"]: option["name"] for option in options},
        {option["name"]: option["unit"] for option in options if option["kind"] in VARIABLE},
        description["one_needed"],
        description["input"],
    )


class Programs(dict):
    """{name: Program} of a folder. Each of TOOLS is asked once, when it is needed first."""

    def __init__(self, folder):
        super().__init__()
        self.folder = Path(folder)

    def __missing__(self, name):
        tool = name.split()[0]
        if tool in TOOLS:
            self.update(self.described_by(tool))
        if name not in self:
            known = TOOLS if tool not in TOOLS else self
            raise SweepError(f"there is no program '{name}'{suggestion(name, known)}")
        return self[name]

    def described_by(self, tool):
        done = subprocess.run([self.folder / tool, "--describe"], capture_output=True, check=False)
        if done.returncode:
            raise SweepError(
                f"'{tool} --describe' ended with {done.returncode}: the program cannot be used"
            )
        description = json.loads(done.stdout)
        programs = description.get("commands", [description])
        return {program["name"]: program_from(program) for program in programs}


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
    programs: Programs

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
            units = self.programs[program].units
            if name not in units:
                raise SweepError(
                    f"{program} has no option '{name}' that takes a value"
                    f"{suggestion(name, [*units, *self.parameters])}"
                    " (the name of a parameter has a dot)"
                )
        return self.programs[programs[0]].units[name]


def names_of(folder_of_tools):
    """As the programs in this folder have them."""
    analyze = Path(folder_of_tools) / "analyze"
    done = subprocess.run([analyze, "quantities", "--json"], capture_output=True, check=False)
    if done.returncode:
        raise SweepError(f"{analyze} is too old for sweeps: it has no command 'quantities'")
    listed = json.loads(done.stdout)
    parameters, quantities = (
        {entry["name"]: entry["unit"] for entry in listed[kind]} for kind in KINDS
    )
    return Names(parameters, quantities, Programs(folder_of_tools))
