"""Chain files as text: sections, what a point needs, and errors that name the place."""

import configparser
import difflib
import math
import re
import shlex
from contextlib import contextmanager

from chains.point import HOLE
from rupture.errors import Failure, UsageError
from rupture.units import one_name

MEGABYTES = {"MB": 1, "GB": 1000}


def is_values(section):
    return section == "values" or section.startswith("variant ")


def existing(path):
    """The file at this path, or at one of the same look."""
    if path.exists() or not (folder := existing(path.parent)).is_dir():
        return path
    same = (one for one in folder.iterdir() if one_name(one.name) == one_name(path.name))
    return next(same, path)


def new_ini():
    """Sections as they are written."""
    ini = configparser.RawConfigParser(
        default_section="", delimiters="=", inline_comment_prefixes="#;"
    )
    ini.optionxform = str  # type: ignore[method-assign, assignment]  # names are case-sensitive
    return ini


def needs_of(section):
    """Megabytes and threads of each point."""
    memory, threads = section.get("memory", "1 GB"), section.get("threads", "1")
    amount = re.fullmatch(r"(\d*\.?\d+)\s*(MB|GB)", memory)
    megabytes = math.ceil(float(amount[1]) * MEGABYTES[amount[2]]) if amount else 0
    if not megabytes:
        wanted = "give a number and MB or GB, as in memory = 2 GB"
        raise UsageError(f"'memory = {memory}' is not understood: {wanted}")
    if not re.fullmatch("[1-9][0-9]{0,3}", threads):
        raise UsageError(f"'threads = {threads}' is not understood: give a whole number from 1")
    return {"megabytes": megabytes, "threads": int(threads)}


def words_of(line):
    """The words of a command; a hole is a part of one."""
    try:
        return shlex.split(HOLE.sub("0", line))
    except ValueError as error:
        raise UsageError(f"'{line}' cannot be split into words ({error})") from None


def suggestion(name, known):
    """Asks whether a known name was meant that is similar, or differs only in capitals."""
    by_lower = {other.lower(): other for other in known}
    near = difflib.get_close_matches(name.lower(), by_lower, n=1)
    return f": did you mean '{by_lower[near[0]]}'?" if near else ""


def check_known(name, known, what):
    if name not in known:
        raise UsageError(f"{what} '{name}'{suggestion(name, known)}")


def place_and_sentence(error):
    """The place and sentence of a configparser.Error, whose own message has several lines."""
    if hasattr(error, "errors"):
        line = str(error).splitlines()[1].partition("]: ")[2]  # in errors, some Pythons quote it
        said = f"expected NAME = VALUE or [SECTION] (got {line})".replace("\\n", "")
        return f"{error.source}, line {error.errors[0][0]}: {said}"
    said = str(error).partition("]: ")[2]
    said = said or f"expected [SECTION] first (got {error.line.strip()!r})"
    return f"{error.source}, line {error.lineno}: {said}"


@contextmanager
def errors_of(path):
    """Raises one sentence with the file: UsageErrors, but a Failure if the system refuses."""
    try:
        yield
    except OSError as error:
        paths = dict.fromkeys((str(path), str(error.filename or path)))
        raise Failure(f"{': '.join(paths)}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise UsageError(f"{path}: it is not UTF-8 text") from None
    except configparser.Error as error:
        raise UsageError(place_and_sentence(error)) from None
    except (Failure, ValueError) as error:
        raise UsageError(f"{path}: {' '.join(str(error).split())}") from None
