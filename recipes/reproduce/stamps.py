"""What a recipe was made from: code, programs, files of users, and what it has written. As long as
all of that stays the same, there is nothing to do for it. Dates only say where to look closer."""

import os
from contextlib import suppress
from pathlib import Path

from claims.recipes import RECIPES, paper_of
from rupture.commands.code import OURS, digest_at, modules_behind, path_of, read_module, stamp_of
from rupture.programs import DRAWING

ASKED = "asked"
JUDGES = ("claims/judge.py", "report/jobs.py", "reproduce/recipes.py")


def record_of(recipe, kind):
    """The name of what is noted about a recipe in the store."""
    return f"recipe-{recipe.replace('/', '.')}-{kind}"


def content_of(path, store):
    if path.suffix == ".py":
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


def is_current(recipe, is_whole, store):
    """`is_whole`: whether all samples are wanted, not only those that are known."""
    stamp = store.result(record_of(recipe, "stamp"))
    if not stamp or is_whole and stamp["lacks"]:
        return False
    if any(store.place(own, "json").exists() for own in stamp["lacks"]):
        return False
    new: dict[str, list] = {}
    for path, (seen, content) in stamp["files"].items():
        with suppress(OSError):
            if seen == [*stamp_of(path)]:
                continue
            new |= described([path], store)
        if new.get(path, ["", ""])[1] != content:
            return False
    if new:
        save(recipe, stamp["files"] | new, stamp["lacks"], store)
    return True
