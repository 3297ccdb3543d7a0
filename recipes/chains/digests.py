"""What results know of programs and scripts: digests of what these compute with.

Of a program they leave out the version that is compiled in, of a script comments and docstrings. So
a commit or a new sentence recomputes nothing, and a changed constant all that it may touch."""

import ast
import os
import struct
from contextlib import suppress
from functools import cache
from pathlib import Path

from chains.point import PROGRAMS
from chains.store import DIGESTS, digest, result_of
from reproduce.project import SHARE
from rupture.programs import DRAWING

PLACES = ("recipes", "python")  # of modules that scripts import
NOT_COMPUTED_WITH = (b".note.gnu.build-id", b".rupture_version")  # cmake/WriteVersion.cmake
MODULES = DIGESTS / "modules.json"
LOADED = 2  # flag of ELF's sections that are in memory when the program runs
NO_BITS = 8  # type of those that have no bytes in the file


# --- programs ----------------------------------------------------------------------------------


def sections(content):
    """(name, bytes) of the sections of a program, as the header of its ELF file lists them, which
    are in memory when it runs."""
    (start,) = struct.unpack_from("<Q", content, 40)
    size, count, of_names = struct.unpack_from("<3H", content, 58)
    headers = [struct.unpack_from("<2I4Q", content, start + n * size) for n in range(count)]
    names = content[headers[of_names][4] :]
    for name, kind, flags, _, place, length in headers:
        if flags & LOADED and kind != NO_BITS:
            yield names[name : names.index(b"\0", name)], content[place : place + length]


@cache
def digest_of_program(path):
    """What a program computes with; of a script all of it."""
    content = Path(path).read_bytes()
    if not content.startswith(b"\x7fELF\x02"):
        return digest(content)
    return digest(*(text for name, text in sections(content) if name not in NOT_COMPUTED_WITH))


# --- scripts -----------------------------------------------------------------------------------


def without_docstrings(tree):
    """The code alone; a docstring is the first statement of its block."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and isinstance(body[0], ast.Expr):
            if isinstance(body[0].value, ast.Constant) and isinstance(body[0].value.value, str):
                body[0].value.value = ""
    return tree


def imported(tree):
    """Names of modules, and of what may be a module in a package."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


@cache
def read_modules():
    """{file: [its date and size, digest of its code, what it imports]}, as of the last time."""
    with suppress(OSError, ValueError):
        return result_of(MODULES)
    return {}


def read_module(path):
    """A digest of its code, and what it imports. To read all takes longer than Ninja does."""
    known, stat = read_modules(), path.stat()
    name, stamp = os.path.relpath(path, SHARE), [stat.st_mtime_ns, stat.st_size]
    if known.get(name, [])[:1] != [stamp]:
        tree = ast.parse(path.read_bytes())
        names = sorted(set(imported(tree)))
        known[name] = [stamp, digest(ast.dump(without_docstrings(tree))), names]
    return known[name][1:]


@cache
def module_at(name, folder):
    """The file of a module of ours; nothing for others."""
    for place in (folder, *(SHARE / place for place in PLACES)):
        found = place.joinpath(*name.split("."))
        for path in (found.with_suffix(".py"), found / "__init__.py"):
            if path.is_file():
                return path
    return None


def digest_of_scripts(*paths):
    """Returns a digest of these scripts and of all our modules that they import, directly or
    not."""
    waiting, parts = [Path(path) for path in paths], {}
    while waiting:
        path = waiting.pop()
        if path not in parts:
            parts[path], names = read_module(path)
            found = (module_at(name, Path(paths[0]).parent) for name in names)
            waiting.extend(one for one in found if one)
    return digest(*(parts[path] for path in sorted(parts)))


# --- both --------------------------------------------------------------------------------------


@cache
def digest_of_tool(tool):
    """Returns the digest of a program, given by name, or of a script, given by its path in the
    project. A script may run all programs. Those that draw are modules, which the programs of their
    names start."""
    folder = Path(os.environ["RUPTURE_BIN"])
    if tool in DRAWING:
        return digest_of_scripts(SHARE / f"python/rupture/tools/{tool}.py")
    if tool.endswith(".py"):
        programs = (digest_of_program(folder / name) for name in PROGRAMS)
        return digest(digest_of_scripts(SHARE / tool), *programs)
    return digest_of_program(folder / tool)
