"""What we have written below results/: its marker lists the SHA-256 and path of each file, of which
the last line counts; with -, the file is being written or was deleted. Nothing else is replaced,
deleted or shown, and what is not as it was written is made again."""

import os
import re
from contextlib import contextmanager
from functools import cache
from pathlib import Path, PurePosixPath

from rupture.commands.folder import HOLDS_LINKS, Marker, complain, read_own, sha256_of
from rupture.errors import Failure
from rupture.tools.command_line import in_one_line, is_seen

MARKER = Marker("rupture-results", "Results of rupture, layout 1. It has written and may delete:\n")
FORMER = ".rupture-files"  # the list of versions 0.4 and 0.5
STORE = "store"  # looks after itself, and may be a link
UNKNOWN = "-"


def is_below(name):
    """Whether it leads to a file below a folder, by a name that we give (sweeps/text.py). Anybody
    may have written the list."""
    path = PurePosixPath(name)
    is_plain = name == str(path) != "." and all(map(is_seen, name))
    return is_plain and not path.is_absolute() and ".." not in path.parts


def written(results):
    """{path relative to `results`: SHA-256 of the file}"""
    try:
        text = read_own(Path(results, MARKER.name)).decode(errors="surrogateescape")
    except FileNotFoundError:
        return {}
    pairs = (line.partition("  ")[::2] for line in text.split("\n")[1:-1])
    return {name: sha256 for sha256, name in pairs if is_below(name)}


def check(results):
    """Raises Failure for a folder that is not ours, or that has links."""
    if os.path.lexists(Path(results, FORMER)):
        raise Failure(f"{results} is of an earlier version: ./reproduce.sh clean deletes its files")
    MARKER.check(results, apart=[STORE])
    for at, folders, files in os.walk(results):
        if Path(at) == Path(results) and STORE in folders:
            folders.remove(STORE)
        for path in (Path(at, name) for name in (*folders, *files)):
            if path.is_symlink() and path != Path(results, STORE):
                raise Failure(f"{path} {HOLDS_LINKS}")


def hold(results):
    """Makes the folder ours; for one call, until that closes what is returned."""
    Path(results).mkdir(parents=True, exist_ok=True)
    check(results)
    return MARKER.lock(results)


def append(results, digests):
    """What follows the last end of a line was not written whole."""
    path = Path(results, MARKER.name)
    if not os.path.lexists(path):
        hold(results).close()
    have = written(results)
    lines = [f"{d}  {name}\n" for name, d in digests.items() if have.get(name) != d]
    end = read_own(path).rindex(b"\n") + 1
    with open(os.open(path, os.O_WRONLY | os.O_NOFOLLOW), "wb") as file:
        file.truncate(end)
        file.seek(end)
        file.write("".join(lines).encode(errors="surrogateescape"))


def names_of(results, paths):
    return dict.fromkeys(str(Path(path).relative_to(results)) for path in paths)


def refuse_others(results, *paths):
    """Raises Failure if one of these files exists below `results` and is not ours."""
    ours = written(results)
    for name in names_of(results, paths):
        path = Path(results, name)
        if os.path.lexists(path) and (name not in ours or path.is_dir() or path.is_symlink()):
            raise Failure(
                f"{path} is not in {results}/{MARKER.name}, or no file, and is not replaced:"
                " move it away"
            )


def take(results, *paths):
    """Call it before files are written. Raises Failure if others are there."""
    refuse_others(results, *paths)
    append(results, dict.fromkeys(names_of(results, paths), UNKNOWN))


def seal(results, *paths):
    """Call it when they are as they shall be."""
    of_each = ((name, Path(results, name)) for name in names_of(results, paths))
    append(results, {n: sha256_of(p) if os.path.lexists(p) else UNKNOWN for n, p in of_each})


def is_intact(path, sha256):
    try:
        return sha256_of(path) == sha256
    except OSError:
        return False


def intact(results, place):
    """The files of ours in a folder below `results`. Raises Failure if one is not as it was
    written."""
    paths = {Path(results, name): sha256 for name, sha256 in written(results).items()}
    ours = {path: sha256 for path, sha256 in paths.items() if path.parent == Path(results, place)}
    for path, sha256 in ours.items():
        if not is_intact(path, sha256) and (sha256 != UNKNOWN or os.path.lexists(path)):
            raise Failure(f"{path} is gone, or not as it was written")
    return sorted(path for path, sha256 in ours.items() if sha256 != UNKNOWN)


@contextmanager
def leave_out(name):
    """Says why a recipe is not shown, or a sweep."""
    try:
        yield
    except Failure as why:
        typed = re.sub("^sweeps/(.*)", r"sweep \1.ini", name)
        complain_once(f"{why}: left out until ./reproduce.sh {typed} has made it again")


@cache
def complain_once(sentence):
    complain(in_one_line(sentence))
