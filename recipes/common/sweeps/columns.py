"""The columns of a user's table, and their units."""

import math
import re
import shlex

from sweeps.names import program_of, suggestion
from sweeps.sweep import SweepError

STATE = ("status", "sentence", "point")  # columns of every table
HEADING = re.compile(r"(?P<name>.*?)(\s*\[(?P<unit>[^\[\]]*)\])?")


def unit_of_quantity(path, commands, names):
    """`path` is the name of a command, then a place in what it reports."""
    command, _, rest = path.partition(".")
    if command not in commands:
        raise SweepError(
            f"'{path}': there is no command '{command}'{suggestion(command, commands)}"
        )
    words = shlex.split(commands[command])
    if words[:1] != ["analyze"] or "--json" not in words:
        raise SweepError(f"'{path}': the command '{command}' is no `analyze ... --json`")
    reads_file = any(word.endswith(".h5") or word == "{base}" for word in words)
    return names.quantity_unit(f"{words[1]}.{rest}", reads_file)


def settle_columns(table, commands, names):
    """{name: path} and {name: unit}. A heading may repeat the unit, as in `speed [m/s]`."""
    columns: dict[str, str] = {}
    units: dict[str, str] = {}
    for heading, path in table.items():
        parts = HEADING.fullmatch(heading)
        assert parts  # as of any text
        name, stated = parts.group("name", "unit")
        unit = unit_of_quantity(path, commands, names)
        if stated not in (None, unit):
            raise SweepError(f"'{heading}' says [{stated}], but {path} has the unit '{unit}'")
        if "/" in name or name in ("", ".", *columns, *STATE):
            raise SweepError(f"'{heading}' cannot be the heading of a column; take another one")
        columns[name], units[name] = path, unit
    return columns, units


def units_of_values(points, commands, names):
    """{name: unit} of what the points set."""
    programs = [program_of(line) for line in commands.values() if "{values}" in line]
    if not programs:
        raise SweepError("no command has {values}")
    return {
        name: "" if name == "variant" else names.value_unit(name, programs)
        for point in points
        for name in point.values
    }


def number_or_text(text, unit):
    """1e-4 and 0.0001 are the same number."""
    try:
        return float(text) if unit else text
    except ValueError:
        return text


def check_value(name, text, unit):
    value = number_or_text(text, unit)
    if unit and not (isinstance(value, float) and math.isfinite(value)):
        kind = "number," if unit == "1" else f"number in {unit}, written without it,"
        raise SweepError(f"{name} is a finite {kind} which '{text}' is not")
    if name != "variant" and shlex.quote(text) != text:
        raise SweepError(f"'{text}' is no value of {name}: use one word without quotation marks")


def check_values(points, units, columns):
    if not any(point.values for point in points):
        raise SweepError(
            "there are no points: [values] or a table of points says for which values to run"
        )
    settings = {
        tuple((name, number_or_text(text, units[name])) for name, text in point.values.items())
        for point in points
    }
    if len(settings) < len(points):
        raise SweepError("a point is there twice; remove the value that is repeated")
    if any({"seed", "numerics.seed"} <= {*point.values} for point in points):
        raise SweepError("seed and numerics.seed are the same; remove one of them from [values]")
    for name in units:
        if name in columns:
            raise SweepError(f"'{name}' is in [values] and the heading of a quantity; rename that")
    for point in points:
        for name, text in point.values.items():
            check_value(name, text, units[name])
