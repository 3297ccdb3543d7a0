"""Command lines of the programs in Python: argparse, a sentence for each error, and --describe."""

import argparse
import difflib
import json
import math
import os
import re
import signal
import sys
import unicodedata
from contextlib import suppress
from functools import partial
from itertools import takewhile

from rupture.errors import Failure, UsageError, is_of_machine
from rupture.programs import output_of
from rupture.replacing import ENDING, end_by_signal
from rupture.units import in_si

CLEAR = "\r\033[K"  # the line of a terminal
WHOLE = re.compile(r"[-+]?\d{1,18}", re.ASCII)
DEFAULT = " (default: %(default)s)"
KINDS = {"FILE": ("output file", ""), "N": ("integer", "1"), "T [s]": ("number", "s")}


def seconds(text):
    """Times such as 0.8, 0.8s or "800 ms" [s]."""
    with suppress(ValueError):
        time, unit = in_si(text.strip())
        if unit in ("", "s") and 0 <= time < math.inf:
            return time
    raise argparse.ArgumentTypeError(f"must be a time, such as 800ms (got '{text}')")


def whole_number(text, least, words=()):
    """Whole numbers from `least` on, or `words` instead."""
    if text in words:
        return text
    if WHOLE.fullmatch(text) and int(text) >= least:
        return int(text)
    expected = ", or ".join((f"a whole number, {least} or more", *words))
    raise argparse.ArgumentTypeError(f"must be {expected} (got '{text}')")


class Answer(argparse.Action):
    """Prints what `const` returns for the parser."""

    def __call__(self, parser, *_):
        print(self.const(parser))
        parser.exit()


def version_text(parser):
    return output_of("analyze", "--version").strip().replace("analyze", parser.name, 1)


def check_short_options(words):
    for word in takewhile("--".__ne__, sys.argv[1:] if words is None else words):
        if re.match("-[A-Za-z]+=", word):
            why = "has an '=' behind a short option: leave a blank, as in -o x.h5"
            raise UsageError(f"'{word}' {why}")


class Parser(argparse.ArgumentParser):
    """Has the options of all programs. `synopsis` begins with the name, `inputs` is the kind of the
    positional arguments. Metavars tell the kinds of values (KINDS)."""

    def __init__(self, synopsis, purpose, inputs, called="rupture {}", version=version_text):
        self.synopsis, self.inputs, self.name = synopsis, inputs, synopsis.split()[0]
        program = called.format(self.name)
        usage = f"{program}{synopsis.removeprefix(self.name)}"
        super().__init__(program, usage, purpose, allow_abbrev=False)
        add = partial(self.add_argument, action=Answer, nargs=0)
        text = "print name, options and input as one JSON object and exit"
        add("--describe", const=Parser.describe, help=text)
        add("--version", const=version, help="show version and exit")

    def add_time(self, name, text, **more):
        self.add_argument(name, type=seconds, metavar="T [s]", help=text, **more)

    def add_output(self, text):
        self.add_argument("-o", "--output", metavar="FILE", required=True, help=text)
        self.add_argument("-f", "--force", action="store_true", help="replace an existing file")
        self.add_argument("-q", "--quiet", action="store_true", help="print errors only")

    def parse_args(self, *given):
        options = super().parse_args(*given)
        if getattr(options, "quiet", False):
            sys.stdout = None  # type: ignore[assignment]  # print() prints nothing then
        return options

    def parse_known_args(self, args=None, namespace=None):
        check_short_options(args)
        return super().parse_known_args(args, namespace)

    def parse_known_intermixed_args(self, args=None, namespace=None):
        check_short_options(args)  # Python 3.13 no longer calls the function above
        return super().parse_known_intermixed_args(args, namespace)

    def error(self, message):
        raise UsageError(f"{message}; see {self.prog} --help")

    def describe(self):
        return json.dumps(self.description_json())

    def description_json(self):
        """docs/schema.md, Programs as JSON"""
        options = [action for action in self._actions if action.option_strings]
        return {
            "name": self.name,
            "synopsis": self.synopsis,
            "purpose": self.description,
            "input": self.inputs,
            "outputs": ["report"],
            "parameters": False,
            "one_needed": [[action.dest] for action in options if action.required],
            "options": [option_json(action) for action in options],
        }


def option_json(action):
    *short, long = action.option_strings
    value = "" if action.nargs == 0 else action.metavar
    kind, unit = KINDS.get(value, ("text" if value else "flag", ""))
    return {
        "name": long.removeprefix("--"),
        "short": short[0].removeprefix("-") if short else None,
        "kind": kind,
        "value": value.partition(" ")[0],
        "unit": unit,
        "default": action.default if value else None,
        "help": action.help.removesuffix(DEFAULT),
    }


def suggestion(name, known):
    """Asks whether a known name was meant that is similar, or differs only in capitals."""
    by_lower = {other.lower(): other for other in known}
    near = difflib.get_close_matches(name.lower(), by_lower, n=1)
    return f": did you mean '{by_lower[near[0]]}'?" if near else ""


def check_known(name, known, what):
    if name not in known:
        raise UsageError(f"{what} '{name}'{suggestion(name, known)}")


def is_seen(letter):
    """No control character, nor another that does not show, or ends a line."""
    return unicodedata.category(letter) not in ("Cc", "Cf", "Cs", "Zl", "Zp")


def in_one_line(text):
    """The text in one line, without control characters, which names of files may contain."""
    return "".join(letter if is_seen(letter) else "?" for letter in text)


def plural(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def complain(name, sentence):
    """Prints a sentence. The middle of a long one, which may quote whole files, is left out."""
    line = in_one_line(sentence)
    line = line if len(line) <= 1000 else f"{line[:700]}…{line[-300:]}"
    with suppress(OSError):  # nobody can read it
        start = CLEAR if sys.stderr.isatty() else ""
        print(f"{start}{name}: {line}", file=sys.stderr, flush=True)


def exit_code(run, say):
    """Calls `run()`. Returns its exit code, or that of an error, which is passed to `say`."""
    try:
        try:
            return run() or 0
        finally:  # also after --help
            if sys.stdout:
                sys.stdout.flush()
    except Failure as error:
        say(error)
        return 2 if isinstance(error, UsageError) else 3 if is_of_machine(error) else 1
    except OSError as error:  # those of other files are Failures
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Python tries once more
        if isinstance(error, BrokenPipeError):  # such as that of `| head`
            return 141
        say(f"{error.filename or 'standard output'}: {error.strerror or error}")
        return 3 if is_of_machine(error) or not error.filename else 1
    except MemoryError:
        say("not enough memory")
        return 3


def run_tool(name, run):
    """Calls `run()` and returns the exit code of the program."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    for number in ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, end_by_signal)
    return exit_code(run, lambda error: complain(f"rupture {name}", str(error)))
