"""Checks a user's sweep against what the programs say of themselves, before it runs."""

import json
import math
import re
from collections import Counter
from contextlib import suppress
from functools import cache

from chains.point import HOLE, PROGRAMS
from rupture.errors import UsageError
from rupture.programs import output_of
from rupture.units import in_si
from chains.ini import check_known, suggestion, words_of
from chains.expressions import Expression, first_known
from chains.values import HEADING

VARIABLE = ("number", "integer", "choice", "text")  # kinds of values; others are files and flags
PATH = re.compile(r"[\w-]+(\.(-?\w+|\*))*")  # to a quantity: front.v_c.28
ELEMENT = "element"  # the column of a number in a list
STATE = ("status", "sentence", "point")  # columns of every table
OPTION = re.compile(r"-[A-Za-z-]")  # how one begins; negative numbers do not
PLAIN = re.compile(r"[A-Za-z0-9_][\w.-]*")  # name of a file in the point's folder
WORDS = re.compile(r"[\w.][\w., +-]*")  # a value that is a text
OUTSIDE = "a point starts in an empty folder, and must not change files elsewhere"
COMPUTES_NOTHING = "it computes nothing then"
REFUSED = {
    "config": "points would not follow what is in that file;"
    " give the parameters with --set or in [values]",
    **dict.fromkeys(("force", "resume"), OUTSIDE),
    **dict.fromkeys(("help", "describe", "version", "dry-run"), COMPUTES_NOTHING),
}


class Programs:
    """What they say of themselves."""

    def __init__(self):
        listed = self.answer("analyze", "quantities", "--json")
        self.parameters = {row["name"]: row for row in listed["parameters"]}
        self.quantities = {row["name"]: row["unit"] for row in listed["quantities"]}

    @cache
    def answer(self, *command):
        return json.loads(output_of(*command))

    def options(self, tool, *words):
        """{--name or -n: what the program says of its option}."""
        check_known(tool, PROGRAMS, "there is no program")
        command = [word for word in words[:1] if tool == "analyze"]
        found = self.answer(tool, *command, "--describe").get("options", [])
        shorts = {f"-{option['short']}": option for option in found if option["short"]}
        return shorts | {f"--{option['name']}": option for option in found}

    def described(self, line):
        """The program's description of this command, which also refuses wrong options."""
        return self.answer(*words_of(line), "--describe")


# --- commands ---------------------------------------------------------------------------------


def given_in(line, programs):
    """The names of the options in a command. What would write elsewhere, or compute nothing, is
    refused here; of an unknown option the program itself has more to say."""
    words = words_of(line)
    known = programs.options(*words)
    for word, following in zip(words, [*words[1:], "--"]):
        option, equals, value = word.partition("=")
        name, kind = (known.get(option, {}).get(key, "") for key in ("name", "kind"))
        if name in REFUSED:
            raise UsageError(f"'{line}' must not have {option}: {REFUSED[name]}")
        if OPTION.match(word) and not name and not re.match("--.", word):
            raise UsageError(f"'{line}': write {option} as single options, such as -q -o x.h5")
        if kind == "output file" and not PLAIN.fullmatch(value if equals else following):
            own = "needs the name of a file in the point's own folder"
            raise UsageError(f"'{line}': {option} {own}, such as end.h5")
        if name:
            yield name


def check_command(line, programs):
    given = [*given_in(line, programs)]
    program = programs.described(line)
    for group in program["one_needed"]:
        if not {*group}.intersection(given):
            needs = f"{program['name']} needs {' or '.join(f'--{name}' for name in group)}"
            raise UsageError(f"{needs}, which '{line}' does not have")
    settings = re.findall(r"(?:^| )--set[ =](\S+?)=", " ".join(words_of(line)))
    settings += ["numerics.seed"] * given.count("seed")  # --seed is short for it
    for name, times in Counter(settings).items():
        if times > 1:
            raise UsageError(f"'{line}' sets {name} twice; remove it from [values] or [commands]")


# --- values -----------------------------------------------------------------------------------


def check_value(name, text, option):
    """The value, as it is compared with others."""
    if text not in option.get("words", [text]):
        raise UsageError(f"{name} must be {' or '.join(option['words'])} (got '{text}')")
    if not (unit := option["unit"]):
        if not WORDS.fullmatch(text):
            raise UsageError(f"{name} must be a word or a name (got '{text}')")
        return text
    with suppress(ValueError):
        number, own = in_si(text)
        if own in ("", unit) and math.isfinite(number):
            return number
    kind = "number" if unit == "1" else f"number in {unit}"
    raise UsageError(f"{name} must be a finite {kind} (got '{text}')")


def option_of(name, line, programs):
    """How the programs describe what this value sets; `line`: the command that has the values."""
    if name == "variant":
        return {"unit": ""}
    if "." in name:
        check_known(name, programs.parameters, "there is no parameter")
        return programs.parameters[name]
    for option in programs.described(line)["options"]:
        if option["name"] == name and option["kind"] in VARIABLE:
            return option
    raise UsageError(f"the option '{name}' cannot vary")


def unit_of(name, points):
    """Returns the unit of a value that is no option; 1 if all are numbers without a unit."""
    texts = {point.texts(point.look_up).get(name) for point in points} - {None}
    try:
        units = {in_si(text)[1] or "1" for text in texts}
    except ValueError:
        return ""
    return units.pop() if len(units) == 1 else ""


def check_points(points, programs):
    """{name: unit} of what the points set."""
    described: dict[str, dict] = {}
    for point in {tuple(point.values): point for point in points}.values():
        filled = {name: HOLE.sub("1", line) for name, line in point.commands.items()}
        for line in filled.values():
            check_command(line, programs)
        lines = [filled[n] for n, line in point.chain.commands.items() if "{values}" in line]
        if point.options and not lines:
            raise UsageError("no command has {values}")
        others = [name for name in point.values if name not in point.options]
        described |= {name: {"unit": unit_of(name, points)} for name in others}
        described |= {name: option_of(name, lines[0], programs) for name in point.options}
    settings = {
        (
            point.of and point.of.id,
            repr(point.elements),
            *((n, check_value(n, text, described[n])) for n, text in point.options.items()),
            *((n, text) for n, text in point.values.items() if n not in point.options),
        )
        for point in points
    }
    if len(settings) < len(points):
        raise UsageError("two points have the same values: remove the repeated value")
    return {name: option["unit"] for name, option in described.items()}


# --- quantities -------------------------------------------------------------------------------


def unit_of_column(path, commands, programs):
    """`path` is the name of a command, then a place in what it reports; of a list, the unit of its
    elements. `analyze strength` reports numbers of a shape, but lists of a file."""
    command, _, rest = path.partition(".")
    if command not in commands:
        like = f"; write one like {command} = analyze {command} record.h5"
        near = suggestion(command, commands) or like
        raise UsageError(f"'{path}': [commands] has no '{command}'{near}")
    words = words_of(commands[command])
    if words[0] != "analyze":
        raise UsageError(f"'{path}': the command '{command}' does not run analyze")
    quantity, known = f"{words[1]}.{rest}", programs.quantities
    pattern = re.sub(r"\.-?\d+(?=\.|$)", ".*", quantity)
    is_list, of_file = f"{pattern}.*" in known, any(word.endswith(".h5") for word in words)
    if pattern in known and not (is_list and of_file):
        return known[pattern]
    if is_list:
        return known[f"{pattern}.*"]
    near = suggestion(pattern, known) or "; rupture analyze quantities lists what there is"
    raise UsageError(f"analyze reports no '{quantity}'{near}")


def check_expression(text, names):
    """What follows a known name is in its report."""
    for dotted in Expression(text, names).names:
        if not first_known(dotted, names):
            name = dotted.partition(".")[0]
            near = suggestion(name, names) or f"; there are {', '.join(sorted(names))}"
            raise UsageError(f"'{text}': there is no '{name}'{near}")


def check_reported(text, names, commands, programs):
    """An expression: its names, and that `analyze` reports what it takes from reports."""
    check_expression(text, names)
    for dotted in Expression(text, names).names:
        command = first_known(dotted, names)
        if command in commands:
            quantity = dotted.replace(command, words_of(commands[command])[1], 1)
            is_part = any(one.startswith(f"{quantity}.") for one in programs.quantities)
            if not is_part or not commands[command].startswith("analyze "):
                unit_of_column(dotted, commands, programs)


def check_columns(chain, values, names, programs):
    """{name: path, or expression} and {name: unit}; `values`: names of values, `names`: of all that
    expressions may have. A heading may repeat the unit of a path, as in `speed [m/s]`; of an
    expression it says the unit."""
    columns: dict[str, str] = {}
    units: dict[str, str] = {}
    taken = [*STATE, ELEMENT, *values]
    if not (rows := chain.sections.get("quantities")):
        sentence = "it needs a section [quantities], as in type = front.type"
        raise chain.error("quantities", "", sentence)
    for heading, path in rows.items():
        with chain.errors_at("quantities", heading):
            ((name, _, stated),) = HEADING.findall(heading)
            if PATH.fullmatch(path):
                unit = unit_of_column(path, chain.commands, programs)
                if stated and unit in ("", "1"):
                    raise UsageError(f"'{heading}': {path} has no unit; leave out [{stated}]")
            else:
                check_reported(path, names, chain.commands, programs)
                element = re.fullmatch(rf"({PATH.pattern})\[\d+\]", path)
                if element and first_known(element[1], names) in chain.commands:
                    unit = unit_of_column(element[1], chain.commands, programs)
                else:
                    unit = stated or "1"
            if stated not in ("", unit):
                raise UsageError(f"'{heading}' says [{stated}], but {path} has the unit '{unit}'")
            if "/" in name or not WORDS.fullmatch(name) or name in (".", *columns, *taken):
                raise UsageError(f"'{heading}' cannot be the heading of a column; take another one")
            columns[name], units[name] = path, unit
    return columns, units
