"""What a recipe was made from: code, programs and files of users. As long as all of that stays the
same, and what it has written too, there is nothing to do for it. Dates only say where to look
closer."""

import os
from contextlib import suppress
from pathlib import Path

from claims.claim import CLAIMS
from claims.recipes import RECIPES, paper_of
from report.written import intact
from reproduce.project import RESULTS
from rupture.commands.code import OURS, digest_at, modules_behind, path_of, read_module, stamp_of
from rupture.commands.folder import complain
from rupture.errors import Failure
from rupture.programs import DRAWING, PACKAGE

ASKED = "asked"
NEEDS = {"asked": [str], "is_finished": bool}  # what is noted of it
STAMP = {"files": {"": list}, "lacks": [str]}
JUDGES = ("claims/judge.py", "report/jobs.py", "reproduce/recipes.py")


def record_of(recipe, kind):
    """The name of what is noted about a recipe in the store."""
    return f"recipe-{recipe.replace('/', '.')}-{kind}"


def content_of(path, store):
    """Anybody may have named a file in the store: only modules of ours are parsed."""
    is_ours = not {RECIPES, PACKAGE}.isdisjoint(path.resolve().parents)
    if is_ours and path.suffix == ".py":
        return read_module(path, store)[0]
    return digest_at(path, stamp_of(path))


def described(paths, store):
    """{path: what tells whether a file has changed}"""
    return {os.path.relpath(p): [[*stamp_of(p)], content_of(Path(p), store)] for p in paths}


def code_of(recipe, store):
    """Take it before the code is imported: it may change meanwhile."""
    own = sorted((RECIPES / recipe).glob("*.py"))
    claims = RECIPES / paper_of(recipe) / "claims.toml"
    others = described(filter(Path.exists, [claims]), store)
    return code_behind([*own, *map(RECIPES.joinpath, JUDGES)], store) | others


def code_behind(modules, store):
    """These, what they import of ours, and the programs."""
    programs = [path_of(name) for name in OURS if name not in DRAWING]
    return described([*modules_behind(modules, store), *programs], store)


def save(recipe, files, lacks, store):
    """`lacks`: ids of commands that nobody had done."""
    store.save(record_of(recipe, "stamp"), {"files": files, "lacks": lacks})


def is_there(recipe, main):
    """Whether its results are there, as they were written."""
    try:
        return Path(RESULTS, recipe, main) in intact(RESULTS, recipe)
    except Failure as why:
        complain(f"{why}: {recipe} is made again")
        return False


def is_current(recipe, is_whole, store, main=CLAIMS):
    """`is_whole`: whether all samples are wanted, not only those that are known; `main`: a file
    that it has certainly written."""
    stamp = store.result(record_of(recipe, "stamp"), STAMP)
    if not (stamp and stamp["files"]) or is_whole and stamp["lacks"] or not is_there(recipe, main):
        return False
    if any(store.place(own, "json").exists() for own in stamp["lacks"]):
        return False
    new: dict[str, list] = {}
    for path, known in stamp["files"].items():
        with suppress(OSError, ValueError, Failure):
            if known[:1] == [[*stamp_of(path)]]:
                continue
            new |= described([path], store)
        if path not in new or new[path][1:] != known[1:]:
            return False
    if new:
        save(recipe, stamp["files"] | new, stamp["lacks"], store)
    return True
