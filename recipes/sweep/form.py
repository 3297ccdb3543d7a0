"""What a user's sweep file may have: its sections and keys, before their content is looked at."""

import shlex

from common.sweeps import SweepError, is_values
from sweep.expand import STARTS
from sweep.names import suggestion

SHORT = ("sweep", "values", "quantities", "analyze")
LONG = ("sweep", "values", "commands", "quantities", "table")
EVERY_SWEEP = ("title", "base", "points", "time", "memory", "threads")
SHORT_SWEEP = tuple(dict.fromkeys((*EVERY_SWEEP, *STARTS, "restart")))
MAY_BE_EMPTY = ("sweep", "analyze")
KEYS_OF_A_POINT = ("commands", "status", "sentence", "checksums")  # point.py


def check_known(name, known, what):
    if name not in known:
        raise SweepError(
            f"there is no {what} '{name}'{suggestion(name, known)} (there are {', '.join(known)})"
        )


def check_sections(ini, known):
    for section in [*ini.sections(), *(["DEFAULT"] if ini.defaults() else [])]:
        if not is_values(section):
            check_known(section, known, "section")
        for name, text in ini[section].items():
            if not text and section not in MAY_BE_EMPTY:
                raise SweepError(f"'{name}' in [{section}] has no value")
    if "sweep" not in ini:
        raise SweepError("it has no section [sweep]")


def check_commands(commands):
    for name, line in commands.items():
        if name in KEYS_OF_A_POINT:
            raise SweepError(f"a command cannot be called '{name}'; take another name")
        try:
            words = shlex.split(line)
        except ValueError as error:
            raise SweepError(f"'{line}' cannot be split into words ({error})") from None
        if any(word.split("=")[0] == "--config" for word in words):
            raise SweepError(
                f"'{line}' must not have --config: points would not follow what is in that file;"
                " give the parameters with --set or in [values]"
            )


def check_form(ini):
    """Raises SweepError. Returns the section that names the columns."""
    is_long = "commands" in ini
    check_sections(ini, LONG if is_long else SHORT)
    for key in ini["sweep"]:
        check_known(key, EVERY_SWEEP if is_long else SHORT_SWEEP, "key in [sweep]")
    tables = [name for name in ("quantities", "table") if name in ini and ini[name]]
    if len(tables) != 1:
        raise SweepError(
            "it needs a section [quantities] that says what to measure, as in type = front.type"
        )
    return tables[0]
