"""Command lines like those of the other programs: a sentence for each error, exit code 1 or 2, and
--describe."""

import argparse
import difflib
import itertools
import json
import math
import os
import re
import signal
import sys
import textwrap
from contextlib import suppress
from functools import partial

from rupture.errors import Failure, UsageError
from rupture.programs import output_of
from rupture.replacing import ENDING, end_by_signal
from rupture.units import in_si

CLEAR = "\r\033[K"  # the line of a terminal
WHOLE = re.compile(r"[-+]?\d{1,18}", re.ASCII)
WORDING = {  # of argparse, and of the programs in C++
    r"^argument (?:-\w/)?": "",
    r"^(\S+): (?=must|is |expected|ignored|invalid)": r"\1 ",
    r"expected one argument": "needs a value",
    r"ignored explicit argument ('.*')": r"takes no value (got \1)",
    r"invalid choice: '(.*)' \(choose from (.*)\)": r"must be one of \2 (got \1)",
    r"^unrecognized arguments: (-\S*).*": r"unknown option '\1'",
    r"^unrecognized arguments: (\S+).*": r"unexpected file '\1': give only one file",
}


def seconds(text, least=0.0, most=math.inf):
    """Times such as 0.8, 0.8s or "800 ms" [s]."""
    time, unit = math.nan, None
    with suppress(ValueError):
        time, unit = in_si(text.strip())
    if unit not in ("", "s"):
        raise argparse.ArgumentTypeError(f"must be a time such as 0.8s or 800ms (got '{text}')")
    if least <= time <= most and math.isfinite(time):
        return time
    up_to = f" and at most {most:g} s" if most < math.inf else ""
    expected = f"a finite time of at least {least:g} s{up_to}"
    raise argparse.ArgumentTypeError(f"must be {expected} (got '{text}')")


def whole_number(text, least, words=()):
    """Whole numbers from `least` on, or `words` instead."""
    if text in words:
        return text
    if WHOLE.fullmatch(text) and int(text) >= least:
        return int(text)
    expected = ", or ".join((f"a whole number, {least} or more", *words))
    raise argparse.ArgumentTypeError(f"must be {expected} (got '{text}')")


class Once(argparse.Action):
    """Stores a value, and refuses a second one, which would silently replace it."""

    given = False

    def __call__(self, parser, namespace, values, option_string=None):
        if self.given:
            raise argparse.ArgumentError(self, "is given more than once")
        self.given = True
        setattr(namespace, self.dest, values)


class Answer(argparse.Action):
    """Prints what `const` returns for the parser. argparse's own help hides a failed write."""

    def __call__(self, parser, *_):
        print(self.const(parser))
        parser.exit()


def version_text(parser):
    return output_of("analyze", "--version").strip().replace("analyze", parser.prog, 1)


def name_in_help(option):
    name, short, default = (option[key] for key in ("name", "short", "default"))
    words = [f"-{short} [ --{name} ]" if short else f"--{name}", option["value"]]
    if option["unit"] not in ("", "1"):
        words.append(f"[{option['unit']}]")
    if default is not None:
        words.append(f"(={default:g})" if isinstance(default, float) else f"(={default})")
    return "  " + " ".join(filter(None, words))


def help_text(parser):
    """The help, made from the description, in the layout of the C++ programs."""
    said = parser.description_json()
    names = [name_in_help(option) for option in said["options"]]
    width = max(map(len, names)) + 3
    text = f"Usage: rupture {said['synopsis']}\n\n{textwrap.fill(said['purpose'], 90)}\n\nOptions:"
    for name, option in zip(names, said["options"]):
        lines = f"\n{' ' * width}".join(textwrap.wrap(option["help"], 79 - width))
        text += f"\n{name:<{width}}{lines}"
    return text


class Parser(argparse.ArgumentParser):
    """`inputs` is the kind of the positional argument; docs/schema.md, Programs as JSON."""

    def __init__(self, name, arguments, purpose, summary, inputs):
        self.summary, self.inputs = summary, inputs
        options = "" if "[options]" in arguments else " [options]"
        self.synopsis, self.called = f"{name} {arguments}{options}", f"rupture {name}"
        super().__init__(name, description=purpose, add_help=False, allow_abbrev=False)
        self.register("action", None, Once)

    def add_argument(self, *names, kind="text", unit="", **more):
        """`kind` and `unit` of the value go into the description."""
        action = super().add_argument(*names, **more)
        vars(action).update(kind=kind, unit=unit)
        return action

    def add_time(self, name, text, least=0.0, most=math.inf, **more):
        read = partial(seconds, least=least, most=most)
        self.add_argument(name, type=read, kind="number", unit="s", metavar="T", help=text, **more)

    def add_output(self, text):
        kind = "output file"
        self.add_argument("-o", "--output", kind=kind, metavar="FILE", required=True, help=text)
        self.add_argument("-f", "--force", action="store_true", help="replace an existing file")

    def error(self, message):
        self.refuse_unknown(message.partition("unrecognized arguments: ")[2].split())
        for pattern, ours in WORDING.items():
            message = re.sub(pattern, ours, message)
        raise UsageError(f"{message}; see {self.called} --help")

    def parse(self):
        """The values given for the options that were added and for those that all programs have."""
        add = partial(self.add_argument, action=Answer, nargs=0)
        add("-h", "--help", const=help_text, help="show this help and exit")
        text = "print name, options and input as one JSON object and exit"
        add("--describe", const=Parser.describe, help=text)
        add("--version", const=version_text, help="show version and exit")
        return self.parse_args()

    def parse_known_args(self, args=None, namespace=None):
        """Of several mistakes, an unknown option is reported first."""
        words = list(sys.argv[1:] if args is None else args)
        try:
            return super().parse_known_args(words, namespace)
        except UsageError as error:
            if "required" in str(error):
                self.refuse_unknown(words)
            raise

    def refuse_unknown(self, words):
        known = [name for action in self.options() for name in action.option_strings]
        for word in itertools.takewhile(lambda word: word != "--", words):
            name = word.split("=")[0]
            if not name.startswith("--") or name in known:
                continue
            begun = [one for one in known if one.startswith(name)]
            if near := begun or difflib.get_close_matches(name, known, 1):
                raise UsageError(f"unknown option '{word}': did you mean '{near[0]}'?")
            self.error(f"unknown option '{word}'")

    def options(self):
        return [action for action in self._actions if action.option_strings]

    def describe(self):
        return json.dumps(self.description_json())

    def description_json(self):
        words = [list(one.choices) for one in self._get_positional_actions() if one.choices]
        return {
            "name": self.prog,
            "synopsis": self.synopsis,
            "purpose": self.description,
            "summary": self.summary,
            "input": self.inputs,
            "outputs": ["report"],
            "parameters": False,
            "one_needed": [[action.dest] for action in self.options() if action.required],
            "options": [option_json(action) for action in self.options()],
        } | ({"words": words[0]} if words else {})


def option_json(action):
    long, *short = sorted(action.option_strings, key=len, reverse=True)
    is_flag = action.nargs == 0
    described = {
        "name": long.removeprefix("--"),
        "short": short[0].removeprefix("-") if short else None,
        "kind": "flag" if is_flag else "choice" if action.choices else action.kind,
        "value": "" if is_flag else "|".join(action.choices or [action.metavar]),
        "unit": action.unit,
        "default": None if is_flag else action.default,
        "help": action.help,
    }
    return described | ({"words": list(action.choices)} if action.choices else {})


def in_one_line(text):
    """The text in one line, without control characters, which names of files may contain."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def plural(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def complain(name, sentence):
    """Of a long sentence, in which words of users and files are, says the beginning and the end."""
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
            sys.stdout.flush()
    except UsageError as error:
        say(error)
        return 2
    except Failure as error:
        say(error)
        return 1
    except OSError as error:  # those of other files are Failures
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Python tries once more
        if isinstance(error, BrokenPipeError):  # such as that of `| head`
            return 141
        say(f"{error.filename or 'standard output'}: {error.strerror or error}")
        return 1
    except MemoryError:
        say("not enough memory")
        return 1


def run_tool(name, run):
    """Calls `run()` and returns the exit code of the program."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    for number in ENDING:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, end_by_signal)
    return exit_code(run, lambda error: complain(f"rupture {name}", str(error)))
