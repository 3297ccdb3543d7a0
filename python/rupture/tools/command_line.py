# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Command lines like those of the other programs: a sentence for each error, exit code 1 or 2, and
--describe."""

import argparse
import json
import re
import signal
import sys

from rupture.errors import Failure
from rupture.programs import output_of


class UsageError(Failure):
    """A command line that asks for what is not possible; exit code 2."""


UNITS = {"": 1, "s": 1, "ms": 1e-3, "us": 1e-6}  # of times [s]


def seconds(text):
    """A time such as 0.8, 0.8s or "800 ms" [s]."""
    found = re.fullmatch(r"([-+.\deE]*\d\.?)\s*([a-z]*)", text.strip())
    if not found or found[2] not in UNITS:
        raise argparse.ArgumentTypeError(f"'{text}' is no time, such as 0.8, 0.8s or 800ms")
    return float(found[1]) * UNITS[found[2]]


class Version(argparse.Action):
    def __call__(self, parser, *_):
        print(output_of("analyze", "--version").replace("analyze", parser.prog, 1), end="")
        parser.exit()


class Describe(argparse.Action):
    def __call__(self, parser, *_):
        print(json.dumps(parser.description_json()))
        parser.exit()


def kind_of(action):
    """The kind of an option's value; docs/schema.md, Programs as JSON."""
    if action.nargs == 0:
        return "flag"
    if action.choices:
        return "choice"
    names = {seconds: "number", float: "number", int: "integer"}
    return names.get(action.type, "output file" if action.dest == "output" else "text")


class Parser(argparse.ArgumentParser):
    """`inputs` is the kind of the positional argument; docs/schema.md, Programs as JSON."""

    def __init__(self, name, arguments, purpose, summary, inputs):
        self.summary, self.inputs = summary, inputs
        usage = f"rupture {name} {arguments} [options]"
        super().__init__(name, usage, purpose, add_help=False, allow_abbrev=False)

    def add_time(self, name, text, **more):
        option = self.add_argument(name, type=seconds, metavar="T[s]", help=text, **more)
        option.unit = "s"  # type: ignore[attr-defined]

    def add_common(self):
        common = self.add_argument_group("Common options")
        common.add_argument("-h", "--help", action="help", help="show this help and stop")
        text = "print name, options and input as one JSON object and stop"
        common.add_argument("--describe", action=Describe, nargs=0, help=text)
        common.add_argument("--version", action=Version, nargs=0, help="show version and stop")

    def add_output(self, text, needed=True):
        self.add_argument("-o", "--output", metavar="FILE", required=needed, help=text)
        self.add_argument("-f", "--force", action="store_true", help="replace a file that exists")

    def error(self, message):
        raise UsageError(message)

    def options(self):
        return [action for action in self._actions if action.option_strings]

    def description_json(self):
        return {
            "name": self.prog,
            "synopsis": self.usage,
            "purpose": self.description,
            "summary": self.summary,
            "input": self.inputs,
            "outputs": ["report"],
            "parameters": False,
            "one_needed": [[action.dest] for action in self.options() if action.required],
            "options": [option_json(action) for action in self.options()],
        }


def option_json(action):
    long, *short = sorted(action.option_strings, key=len, reverse=True)
    kind = kind_of(action)
    value = "|".join(action.choices) if action.choices else action.metavar
    described = {
        "name": long.removeprefix("--"),
        "short": short[0].removeprefix("-") if short else None,
        "kind": kind,
        "value": "" if kind == "flag" else value,
        "unit": getattr(action, "unit", ""),
        "default": None if kind == "flag" else action.default,
        "help": action.help,
    }
    return described | ({"words": list(action.choices)} if action.choices else {})


def run_tool(name, run):
    """Calls `run` with nothing: the exit code of the program."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    try:
        run()
    except UsageError as error:
        print(f"rupture {name}: {error}; see rupture {name} --help", file=sys.stderr)
        return 2
    except (Failure, OSError, MemoryError) as error:
        print(f"rupture {name}: {error or 'not enough memory'}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0
