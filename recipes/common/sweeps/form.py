"""Sections and keys of a user's sweep file, checked before their content is looked at."""

from sweeps.expand import STARTS
from sweeps.names import (
    options_in,
    parameters_in,
    program_of,
    setting,
    suggestion,
)
from sweeps.sweep import SweepError, is_values

SHORT = ("sweep", "values", "quantities", "analyze")
LONG = ("sweep", "values", "commands", "quantities", "table")
EVERY_SWEEP = ("title", "base", "points", "memory", "threads")
SHORT_SWEEP = tuple(dict.fromkeys((*EVERY_SWEEP, *STARTS, "restart")))
MAY_BE_EMPTY = ("sweep", "analyze")
KEYS_OF_A_POINT = ("commands", "status", "sentence", "checksums", "origin")  # point_store.py

NOTHING_COMPUTED = "it computes nothing then"
NO_FILES_OUTSIDE = "a point starts in an empty folder, and must not change files elsewhere"
REFUSED = {
    "config": "points would not follow what is in that file;"
    " give the parameters with --set or in [values]",
    **dict.fromkeys(("f", "force", "resume"), NO_FILES_OUTSIDE),
    **dict.fromkeys(("h", "help", "describe", "version", "dry-run"), NOTHING_COMPUTED),
}


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


def check_name(name):
    if name in KEYS_OF_A_POINT:
        raise SweepError(f"a command cannot be called '{name}'; take another name")


def check_command(line, programs):
    """Its program and options."""
    given = options_in(line)
    for name in given:
        if name in REFUSED:
            dashes = "-" if len(name) == 1 else "--"
            raise SweepError(f"'{line}' must not have {dashes}{name}: {REFUSED[name]}")
    program = program_of(line)
    known = programs[program].long_names
    for name in given:
        if name not in known:
            raise SweepError(f"{program} has no option '{name}'{suggestion(name, known)}")


def check_needed(line, values, programs):
    """Options without which its program does nothing. `values` are those of the points."""
    name = program_of(line)
    program = programs[name]
    given = {program.long_names[option] for option in options_in(line)}
    if "{values}" in line:
        given |= {*values}
    for group in program.one_needed:
        if not given.intersection(group):
            options = " or ".join(f"--{option}" for option in group)
            raise SweepError(f"{name} needs {options}, which '{line}' does not have")


def check_given_once(line, values):
    """A varied parameter must not be set beside {values}, too: all points would be the same run."""
    varied = {setting(name) for name in values} if "{values}" in line else ()
    for name in (*options_in(line), *parameters_in(line)):
        if setting(name) in varied:
            raise SweepError(f"{name} is both in [values] and in '{line}'; remove one of them")


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
