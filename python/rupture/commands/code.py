"""Digests of what programs and Python functions compute with.

Of a program they leave out the version that is compiled in, of a module comments and docstrings. So
a commit or a new sentence recomputes nothing, and a changed constant all that it may touch."""

import ast
import hashlib
import os
import re
import shutil
import struct
import sys
import sysconfig
import time
from contextlib import suppress
from functools import cache, partial
from pathlib import Path

from rupture.commands.folder import open_regular
from rupture.errors import Failure, UsageError
from rupture import programs
from rupture.programs import DRAWING, PACKAGE

WRITERS = ("load", "prepare", "restart", "modify-phi")  # they write checkpoints and records
OURS = ("analyze", *WRITERS, *DRAWING)
OF_BUILD = b".rupture_version"  # cmake/WriteVersion.cmake
NOT_COMPUTED_WITH = (b".note.gnu.build-id", OF_BUILD)
ELF = b"\x7fELF\x02"
VERSION = re.compile(r"\d+\.\d+\.\d+")
LOADED, NO_BITS = 2, 8  # in ELF: a flag of sections in memory; the type of those without bytes
LONGEST = 250  # of the name of a module [bytes], which is a file's
BEGAN = time.time()
STANDARD = sysconfig.get_paths()["stdlib"]


def digest(*parts):
    """SHA-256 of texts and bytes, in 16 digits."""
    found = hashlib.sha256()
    for part in parts:
        content = part if isinstance(part, bytes) else part.encode()
        found.update(b"%d\0" % len(content) + content)
    return found.hexdigest()[:16]


def stamp_of(path):
    """It differs if a file was changed or exchanged, whatever the clock said."""
    stat = os.lstat(path)
    return stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns


@cache
def digest_at(path, _stamp):
    """The digest of a file; of a program only what is in memory when it runs."""
    content = bytes_of(path)
    if content.startswith(ELF):
        with suppress(struct.error, ValueError, IndexError, OverflowError):  # it is no program
            pairs = [*sections(content)]
            return digest(*(text for name, text in pairs if name not in NOT_COMPUTED_WITH))
    return digest(content)


def bytes_of(path):
    """Of a file of anybody."""
    try:
        with open_regular(path) as file:
            return file.read()
    except OSError as error:
        raise Failure(f"cannot read {path}: {error.strerror}") from error


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
def build_at(path, _stamp):
    """Version and commit of a program of ours; None of any other."""
    content = Path(path).read_bytes()
    of_build = dict(sections(content)).get(OF_BUILD) if content.startswith(ELF) else None
    if not of_build:
        return None
    texts = sorted(text.decode() for text in of_build.split(b"\0") if text)
    version = next(text for text in texts if VERSION.fullmatch(text))
    return f"rupture {version}, commit {next(text for text in texts if text != version)}"


def path_of(program):
    """The path of a program of ours, or of any other on the PATH."""
    found = programs.path_of(program) if program in OURS else shutil.which(program)
    if not found:
        raise UsageError(f"there is no program {program}, neither in rupture nor on the PATH")
    return os.path.abspath(found)


def digest_of_program(program, store):
    """The digest of a program, or of the modules of one that draws, and of `analyze`."""
    if program in DRAWING:
        modules = digest_of_modules(PACKAGE / f"tools/{program}.py", store)
        return digest(modules, digest_of_program("analyze", store))
    return digest_at(path_of(program), stamp_of(path_of(program)))


def digest_of_function(function, store):
    """The digest of its module, what this imports of ours, and programs, which it may run."""
    module = Path(function.__code__.co_filename).resolve()
    programs = (digest_of_program(name, store) for name in ("analyze", *WRITERS))
    return digest(digest_of_modules(module, store), function.__qualname__, *programs)


# --- modules -----------------------------------------------------------------------------------


def blocks_with_docstrings(tree):
    """A docstring is the first statement of its block."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and isinstance(body[0], ast.Expr):
            if isinstance(body[0].value, ast.Constant) and isinstance(body[0].value.value, str):
                yield body


def without_docstrings(tree):
    for body in blocks_with_docstrings(tree):
        del body[0]
    return tree


def imported(tree):
    """(level, name) of what may be modules: a.b.c of `from a.b import c`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((0, one.name) for one in node.names)
        elif isinstance(node, ast.ImportFrom):
            names = (f"{node.module or ''}.{one.name}" for one in node.names)
            yield from ((node.level, name.strip(".")) for name in names)


def folders_of_modules():
    """Where modules of ours and of users are, not those of others."""
    others = ("site-packages", "dist-packages")
    return [Path(p) for p in sys.path if not p.startswith(STANDARD) | p.endswith(others)]


def is_import(one, highest):
    """Of a module, whose relative imports have up to so many dots. Anybody may have named it."""
    if not isinstance(one, list) or [*map(type, one)] != [int, str]:
        return False
    is_name = all(part == "*" or part.isidentifier() for part in one[1].split("."))
    return is_name and len(one[1].encode()) < LONGEST and 0 <= one[0] <= highest


@cache
def form_of_code(folder):
    """Of what the store has of a module in a folder. Its imports lead to no folder around all
    modules."""
    tops = [top.resolve() for top in (*folders_of_modules(), PACKAGE.parent)]
    below = [len(folder.relative_to(top).parts) for top in tops if folder.is_relative_to(top)]
    return {"code": str, "imports": [partial(is_import, highest=1 + max(below, default=0))]}


def read_module(path, store):
    """A digest of its code, and what it imports. The store has both for each text."""
    if os.stat(path).st_ctime > BEGAN:  # what was imported may be another text
        raise Failure(f"{path} has changed meanwhile: start again")
    own = digest("code", source := path.read_bytes())
    if not (known := store.result(own, form_of_code(path.resolve().parent))):
        tree = ast.parse(source)
        imports = sorted(set(imported(tree)))
        known = {"code": digest(ast.dump(without_docstrings(tree))), "imports": imports}
        store.save(own, known)
    return known["code"], known["imports"]


@cache
def modules_at(level, name, folder):
    """The files of a module of ours, and of the packages around it; none of others."""
    places = [folder.joinpath(*[".."] * (level - 1))]
    if not level:
        places += folders_of_modules()
        places += [PACKAGE.parent] * name.startswith("rupture")
    parts, found = name.split("."), []
    for n in range(1, len(parts) + 1):
        paths = (place.joinpath(*parts[:n]) for place in places)
        files = (file for path in paths for file in (path.with_suffix(".py"), path / "__init__.py"))
        found += [file.resolve() for file in files if file.is_file()][:1]
    return found


def modules_behind(paths, store):
    """{path: a digest of its code} of these and all of ours that they import, directly or not."""
    waiting, codes = [*paths], {}
    while waiting:
        if (path := waiting.pop()) not in codes:
            codes[path], imports = read_module(path, store)
            waiting += [one for level, n in imports for one in modules_at(level, n, path.parent)]
    return codes


@cache
def digest_of_modules(path, store):
    return digest(*sorted(modules_behind([path], store).values()))
