"""Digests of what programs and Python functions compute with.

Of a program they leave out the version that is compiled in, of a module comments and docstrings. So
a commit or a new sentence recomputes nothing, and a changed constant all that it may touch."""

import ast
import hashlib
import os
import shutil
import struct
import sys
import sysconfig
from functools import cache
from pathlib import Path

from rupture.errors import UsageError
from rupture.programs import DRAWING, PACKAGE, command_of

RUNS = ("load", "prepare", "restart", "modify-phi")  # they write checkpoints and records
OURS = ("analyze", *RUNS, *DRAWING)
NOT_COMPUTED_WITH = (b".note.gnu.build-id", b".rupture_version")  # cmake/WriteVersion.cmake
LOADED, NO_BITS = 2, 8  # in ELF: a flag of sections in memory; the type of those without bytes
OTHERS = tuple(sysconfig.get_paths()[name] for name in ("stdlib", "purelib", "platlib"))


def digest(*parts):
    """SHA-256 of texts and bytes, in 16 digits."""
    found = hashlib.sha256()
    for part in parts:
        content = part if isinstance(part, bytes) else str(part).encode()
        found.update(b"%d\0" % len(content) + content)
    return found.hexdigest()[:16]


def stamp_of(path):
    """It differs if a file was changed or exchanged, whatever the clock said."""
    stat = os.stat(path)
    return stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns


@cache
def digest_at(path, _stamp):
    """Of a file; of a program only what is in memory when it runs."""
    content = Path(path).read_bytes()
    if not content.startswith(b"\x7fELF\x02"):
        return digest(content)
    return digest(*(text for name, text in sections(content) if name not in NOT_COMPUTED_WITH))


# --- programs ----------------------------------------------------------------------------------


def sections(content):
    """Name and bytes of the sections that an ELF file has in memory, as its header lists them."""
    (start,) = struct.unpack_from("<Q", content, 40)
    size, count, of_names = struct.unpack_from("<3H", content, 58)
    headers = [struct.unpack_from("<2I4Q", content, start + n * size) for n in range(count)]
    names = content[headers[of_names][4] :]
    for name, kind, flags, _, place, length in headers:
        if flags & LOADED and kind != NO_BITS:
            yield names[name : names.index(b"\0", name)], content[place : place + length]


@cache
def path_of(program):
    """Where a program is: one of ours, or any other on the PATH."""
    if program not in OURS:
        if found := shutil.which(program):
            return found
        raise UsageError(f"there is no program {program}: neither in rupture nor on the PATH")
    path, *more = command_of(program)
    if not more:
        return path
    folder = Path(str(shutil.which(path))).resolve().parent  # `rupture`, which starts it
    places = (folder / program, folder.parent / "libexec/rupture" / program)
    return str(next(place for place in places if place.exists()))


def digest_of_program(program, store):
    """Of one that draws: of its modules, and of `analyze`, which it asks."""
    if program in DRAWING:
        modules = digest_of_modules(PACKAGE / f"tools/{program}.py", store)
        return digest(modules, digest_of_program("analyze", store))
    return digest_at(path_of(program), stamp_of(path_of(program)))


def digest_of_function(function, store):
    """Of its module and what this imports of ours; it may run programs."""
    module = Path(sys.modules[function.__module__].__file__).resolve()
    programs = (digest_of_program(name, store) for name in ("analyze", *RUNS))
    return digest(digest_of_modules(module, store), function.__qualname__, *programs)


# --- modules -----------------------------------------------------------------------------------


def without_docstrings(tree):
    """A docstring is the first statement of its block."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and isinstance(body[0], ast.Expr):
            if isinstance(body[0].value, ast.Constant) and isinstance(body[0].value.value, str):
                body[0].value.value = ""
    return tree


def imported(tree):
    """(level, name) of modules, of packages around them, and of what may be a module in one."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [(0, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [
                (node.level, f"{node.module or ''}.{one.name}".strip(".")) for one in node.names
            ]
        else:
            continue
        for level, name in names:
            parts = name.split(".")
            yield from ((level, ".".join(parts[:n])) for n in range(1, len(parts) + 1))


def read_module(path, store):
    """[digest of its code, what it imports]; the store remembers both."""
    source = path.read_bytes()
    own = digest("code", source)
    if not (known := store.result(own)):
        tree = ast.parse(source)
        names = sorted(set(imported(tree)))
        known = {"code": digest(ast.dump(without_docstrings(tree))), "imports": names}
        store.save(own, known)
    return known["code"], known["imports"]


@cache
def module_at(level, name, folder):
    """The file of a module of ours; None for others."""
    folders = [folder, *(Path(p) for p in sys.path if not p.startswith(OTHERS))]
    if name.split(".")[0] == "rupture":
        folders.append(PACKAGE.parent)
    for place in [folder.joinpath(*[".."] * (level - 1))] if level else folders:
        found = place.joinpath(*name.split("."))
        for path in (found.with_suffix(".py"), found / "__init__.py"):
            if path.is_file():
                return path.resolve()
    return None


def digest_of_modules(path, store):
    """Of this one and all of ours that it imports, directly or not."""
    waiting, parts = [path], {}
    while waiting:
        path = waiting.pop()
        if path not in parts:
            parts[path], names = read_module(path, store)
            found = (module_at(level, name, path.parent) for level, name in names)
            waiting.extend(one for one in found if one)
    return digest(*sorted(parts.values()))
