"""Folders of ours, into which anybody may have put anything. A marker says whose a folder is, and
of which layout; one call at a time works in it. What is read there are regular files of a bounded
size and no links, and their JSON has the form that it must have."""

import errno
import fcntl
import hashlib
import json
import os
import re
import stat
import sys
from contextlib import suppress
from pathlib import Path
from types import UnionType
from typing import NamedTuple

from rupture.errors import Failure
from rupture.tools.command_line import in_one_line

LARGEST = 2**28  # of a file that is read as a whole [bytes]
DEEPEST = 20  # lists within each other that are shown
HOLDS_LINKS = "is a link, which is not followed: move it away"


def complain(sentence):
    print(in_one_line(sentence), file=sys.stderr, flush=True)


def open_regular(path, flags=0):
    """For reading; neither a pipe, for whose other end one would wait, nor a device."""
    number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | flags)
    if stat.S_ISREG(os.fstat(number).st_mode):
        return open(number, "rb")
    os.close(number)
    raise OSError(errno.EINVAL, "not a regular file", os.fspath(path))


def open_own(path):
    """It is no link, either."""
    return open_regular(path, os.O_NOFOLLOW)


def open_bounded(path, most):
    if os.lstat(path).st_size > most:
        raise OSError(errno.EINVAL, f"has more than {most} bytes", os.fspath(path))
    return open_own(path)


def read_own(path):
    """Its bytes."""
    with open_bounded(path, LARGEST) as file:
        return file.read(LARGEST)


def sha256_of(path, most=16 * LARGEST):
    with open_bounded(path, most) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def fits(value, form):
    """Whether a value from JSON has a form: a type, a pattern, a function that says so, the [form]
    of items, or a dict with the forms of values by name: "" is any, "x?" may be missing."""
    if isinstance(form, list):
        return isinstance(value, list) and all(fits(one, form[0]) for one in value)
    if isinstance(form, dict):
        of = {name.rstrip("?"): its for name, its in form.items()}
        is_whole = isinstance(value, dict) and {n for n in form if n and n[-1] != "?"} <= {*value}
        return is_whole and all(fits(v, of.get(n, of.get("", nothing))) for n, v in value.items())
    if isinstance(form, re.Pattern):
        return isinstance(value, str) and bool(form.fullmatch(value))
    return isinstance(value, form) if isinstance(form, (type, UnionType)) else form(value)


def nothing(_):
    return False


def integer(text):
    """Larger ones than a seed are none of ours, and no number of floating point may have them."""
    if len(text) > len(str(2**64)):
        raise ValueError(f"{text[:20]}… is too large")
    return int(text)


def in_lines(value, deepest=DEEPEST):
    """JSON that readers see: its texts are lines without control characters."""
    if isinstance(value, str):
        return in_one_line(value)
    if isinstance(value, (list, dict)) and not deepest:
        raise ValueError("it is nested too deeply")
    if isinstance(value, list):
        return [in_lines(one, deepest - 1) for one in value]
    if isinstance(value, dict):
        return {in_one_line(name): in_lines(one, deepest - 1) for name, one in value.items()}
    return value


def parsed(text, form, change=lambda value: value, **options):
    """JSON, after a change, of a form. Raises ValueError for any other."""
    try:
        value = change(json.loads(text, parse_int=integer, **options))
    except RecursionError:
        raise ValueError("it is nested too deeply") from None
    if not fits(value, form):
        raise ValueError("values are missing, or of another type")
    return value


class Marker(NamedTuple):
    """A file of a folder of ours, and its first line."""

    name: str
    layout: str

    def check(self, folder, apart=()):
        """Raises Failure for a folder with files of others, or with links but for those `apart`."""
        inside = [one for one in os.scandir(folder) if one.name not in apart]
        if inside and self.name not in {one.name for one in inside}:
            raise Failure(
                f"{folder} has other files, and no {self.name} to say that rupture wrote them:"
                " move it away, or name a new folder"
            )
        for one in inside:
            if one.is_symlink():
                raise Failure(f"{one.path} {HOLDS_LINKS}")

    def is_in(self, folder):
        """Whether it is ours, of this layout."""
        with suppress(OSError):
            return read_own(Path(folder, self.name)).startswith(self.layout.encode())
        return False

    def lock(self, folder):
        """The marker, for one call until that closes it; a new one in an empty folder."""
        path = Path(folder, self.name)
        flags = os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK
        lock = open(os.open(path, flags, 0o666), "rb+", buffering=0)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Failure(f"another call uses {folder}: wait until it has ended") from None
        except OSError as error:  # of some shared file systems
            complain(f"cannot lock {folder} ({error.strerror}): do not start a second call")
        if not (path.exists() and os.path.samestat(os.fstat(lock.fileno()), os.stat(path))):
            raise Failure(f"{folder} was cleaned meanwhile: start again")
        layout = self.layout.encode()
        if not layout.startswith(found := read_own(path)[: len(layout)]):
            said = found.decode(errors="replace").partition("\n")[0]
            raise Failure(f"{folder} is of another version ({said}): move it away")
        lock.write(layout[len(found) :])
        return lock
