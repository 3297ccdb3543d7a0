"""Commands of a sweep. A command is split into words first; then holes are filled inside of words,
and these words are checked by the program's description of itself. They are the words that run."""

import json
import math
import os
import re
import shlex
from contextlib import suppress
from functools import cached_property

from rupture.commands.code import WRITERS
from rupture.commands.identity import AT_TIME, PLAIN, outputs_in
from rupture.errors import UsageError
from rupture.programs import output_of
from rupture.tools.command_line import check_known, suggestion
from rupture.units import AMOUNT, in_si
from sweeps.values import is_along_x

PROGRAMS = ("analyze", *WRITERS)
HOLE = re.compile(r"\{([^{}]*)\}")
MASK = re.compile("\0([0-9]+)\0")  # no text has these
VALUES = "values"
VARIABLE = ("number", "integer", "choice", "text")  # kinds of values; others are files and flags
SEVERAL = ("set", "checkpoint-at")  # options that may be given more than once
OUTSIDE = "a point starts in an empty folder, and must not change files elsewhere"
NOTHING = "it computes nothing then"
REFUSED = {
    "config": "give the parameters with --set or in [values]",
    "also": "give each option a command of its own",
    **dict.fromkeys(("force", "resume"), OUTSIDE),
    **dict.fromkeys(("help", "describe", "version", "dry-run"), NOTHING),
}


class Given(str):
    """A word that begins with a value, and so may be no option."""


class Later(str):
    """A word with something that is not reported yet."""


class Described:
    """What the programs say of themselves."""

    def __init__(self):
        parameters = self.answer("parameters", "--json")["parameters"]
        quantities = self.answer("analyze", "quantities", "--json")["quantities"]
        self.parameters = {row["name"]: row for row in parameters}
        self.quantities = {row["name"]: row["unit"] for row in quantities}
        self.commands = {}

    def answer(self, *words):
        return json.loads(output_of(*words))

    def options(self, call):
        """{--name or -n: an option} of a program, or of a command of analyze."""
        if call not in self.commands:
            self.commands[call] = self.answer(*call, "--describe")
            found = self.commands[call]["options"]
            shorts = {f"-{option['short']}": option for option in found if option["short"]}
            names = {f"--{option['name']}": option for option in found}
            self.commands[call]["by_word"] = names | shorts
        return self.commands[call]["by_word"]

    def unit_of(self, name, call):
        """That of a value of this name, which an option of this program or a parameter has."""
        if name in self.parameters:
            return self.parameters[name]["unit"]
        option = self.options(call).get(f"--{name}", {"kind": ""})
        return option["unit"] if option["kind"] in VARIABLE else None


class Command:
    """A line of [commands]. `parts`: of each word, texts and, at odd places, names in holes."""

    def __init__(self, name, line, described):
        self.name, self.line, self.described = name, line.removeprefix("rupture "), described
        self.holes = HOLE.findall(self.line)
        if re.search(r"[{}]", HOLE.sub("", self.line)):
            raise UsageError(f"'{self.line}': a brace is missing")
        numbers = iter(range(len(self.holes)))
        try:
            words = shlex.split(HOLE.sub(lambda _: f"\0{next(numbers)}\0", self.line))
        except ValueError as error:
            raise UsageError(f"'{self.line}' cannot be split into words ({error})") from None
        self.parts = [self.parts_of(word) for word in words]
        first = ["".join(parts) for parts in self.parts]  # with names of holes, if it has any
        check_known("".join(first[:1]), PROGRAMS, "there is no program")
        self.call = tuple(first[: 1 + (first[0] == "analyze")])
        described.options(self.call)  # which must be one
        self.begin, self.checked, self.is_later = len(self.call), {}, False

    def parts_of(self, word):
        parts = MASK.split(word)
        if self.holes and VALUES in (parts[1::2] and [self.holes[int(n)] for n in parts[1::2]]):
            if len(parts) > 3 or parts[0] or parts[2]:
                raise UsageError(f"'{self.line}': {{values}} stands alone, as several words")
        return [self.holes[int(part)] if n % 2 else part for n, part in enumerate(parts)]

    @property
    def program(self):
        return self.call[0]

    @cached_property
    def outputs(self):
        """Names of the files that it writes, as they are typed."""
        return outputs_in(["{}".join(parts[::2]) for parts in self.parts])

    def outputs_of(self, words):
        return outputs_in(words) if self.holes else self.outputs

    def filled(self, text_of, options):
        """Its words; None if there is no value for one. `text_of(name)`: the text of a value, None
        for none, Later for what is not known yet; `options`: words for {values}."""
        words = [*self.call]
        for parts in self.parts[self.begin :]:
            if len(parts) == 1:
                words += parts
            elif parts[1] == VALUES:
                words += options
            else:
                texts = [text_of(part) if n % 2 else part for n, part in enumerate(parts)]
                if None in texts:
                    return None
                kind = Given if not texts[0] else str
                kind = Later if any(isinstance(text, Later) for text in texts) else kind
                words.append(kind("".join(texts)))
        return words

    # --- the check -----------------------------------------------------------------------------

    def check(self, words, is_file):
        """Raises UsageError for words that the program does not take, or that a sweep must not
        have. `is_file(word)`: whether there is such an input."""
        options, rest = self.described.options(self.call), [*words[: self.begin - 1 : -1]]
        given: dict[str, str] = {}
        while rest:
            word = rest.pop()
            if not is_option(word):
                self.check_input(word, is_file)
                continue
            if isinstance(word, Given):
                raise UsageError(f"'{self.line}': the value '{word}' would be an option")
            typed, equals, value = word.partition("=") if word[:2] == "--" else (word, "", "")
            if not (option := options.get(typed)):
                self.refuse_option(typed, options)
            name, kind = option["name"], option["kind"]
            if name in REFUSED:
                raise UsageError(f"'{self.line}' must not have {typed}: {REFUSED[name]}")
            if not equals and kind != "flag":
                value = self.value_of(option, rest)
            if kind == "parameter":
                name, value, option = self.setting(value)
            if (value or kind not in ("flag", "number")) and (name, value) not in self.checked:
                self.check_option(typed, name, value, option, is_file)
            if name in given and name not in SEVERAL and not is_along_x(value):
                raise UsageError(f"'{self.line}' sets {name} twice: give it once")
            given[name] = value
        self.check_needed(given)

    def value_of(self, option, rest):
        """Some numbers may be left out; the program knows which."""
        if rest and (isinstance(rest[-1], Given) or not is_option(rest[-1])):
            return rest.pop()
        if option["kind"] != "number":
            raise UsageError(f"'{self.line}': --{option['name']} needs a value")
        return ""

    def refuse_option(self, typed, options):
        if not typed.startswith("--") or typed == "--":
            raise UsageError(f"'{self.line}': write {typed} as single options, such as -q -o x.h5")
        near = suggestion(typed, [name for name in options if name.startswith("--")])
        raise UsageError(f"'{self.line}': {self.program} has no option {typed}{near}")

    def setting(self, text):
        """Name and value of a parameter, and its description."""
        name, equals, value = text.partition("=")
        if not equals:
            raise UsageError(f"'{self.line}': write --set NAME=VALUE (got '{text}')")
        check_known(name, self.described.parameters, "there is no parameter")
        return name, type(text)(value), self.described.parameters[name]

    def check_option(self, typed, name, value, option, is_file):
        kind = option.get("kind")
        if is_option(value):
            raise UsageError(f"'{self.line}': the value '{value}' would be an option")
        if kind == "output file" and not PLAIN.fullmatch(value):
            own = "needs the name of a file in the point's own folder, such as end.h5"
            raise UsageError(f"'{self.line}': {typed} {own} (got '{value}')")
        if kind == "input file":
            if not is_file(value):
                raise UsageError(f"'{self.line}': there is no file {value} beside the sweep")
        elif not isinstance(value, Later):
            check_value(name, value, option)
            self.checked[name, value] = True

    def check_input(self, word, is_file):
        """A word that is no option: a file, or the number that a flag may have."""
        if AMOUNT.fullmatch(word) or is_file(word):
            return
        kind = self.described.commands[self.call]["input"]
        if kind in ("checkpoint", "record", "file"):
            where = "no command before it writes it, nor is it a file beside the sweep"
            raise UsageError(f"'{self.line}': there is no {word}: {where}")
        if kind is None:
            raise UsageError(f"'{self.line}': unexpected word '{word}'")

    def check_needed(self, given):
        for group in self.described.commands[self.call]["one_needed"]:
            if not {*group}.intersection(given):
                needs = f"{self.program} needs {' or '.join(f'--{name}' for name in group)}"
                raise UsageError(f"{needs}, which '{self.line}' does not have")


def is_option(word):
    """Negative numbers are none."""
    return word.startswith("-") and not AMOUNT.match(word)


def check_value(name, text, described):
    """A number in the unit, or one of the words; several between commas; along x, each part. Of a
    condition only the program knows whether it is one."""
    if described.get("value") == "T/CONDITION" and re.search("[<>]", text):
        return
    words = described.get("words")
    for one in text.split(","):
        value, *place = re.split(" from | to ", one) if is_along_x(one) else [one]
        if words and value not in words:
            raise UsageError(f"{name} must be {' or '.join(words)} (got '{text}')")
        if not words and (unit := described["unit"]):
            check_number(name, value, unit)
        for x in place:
            check_number(f"a place of {name}", x, "m")


def check_number(name, text, unit):
    with suppress(ValueError):
        number, own = in_si(text)
        if own in ("", unit) and math.isfinite(number):
            return
    kind = "number" if unit == "1" else f"number in {unit}"
    raise UsageError(f"{name} must be a finite {kind} (got '{text}')")


def options_of(values, described):
    """Values as words."""
    for name, text in values.items():
        if name not in described.parameters:
            yield from (f"--{name}", Given(text))
            continue
        for part in text.split(" and ") if is_along_x(text) else [text]:
            yield from ("--set", f"{name}={part}")


def file_in(folder):
    """Whether there is a file of the user; each is looked for once."""
    known = {}

    def is_there(word):
        if word not in known:
            known[word] = os.path.isfile(os.path.join(folder, word))
        return known[word]

    return is_there


def without_time(word):
    """end.h5 of its checkpoint end-t0.200000000.h5."""
    return AT_TIME.sub("", word)
