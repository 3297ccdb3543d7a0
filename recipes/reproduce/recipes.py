"""Computes what a recipe asks for, draws its figure and judges its claims."""

import shutil
from functools import partial
from importlib import import_module
from pathlib import Path
from sys import modules
from tempfile import TemporaryDirectory

from claims.claim import CLAIMS, write_claims
from claims.judge import claim_of, judge
from claims.recipes import RECIPES, label
from claims.samples import Sampling
from claims.table import rows_of
from report.jobs import builds_of, jobs_of, write_jobs
from report.written import is_intact, refuse_others, seal, take, written
from reproduce import stamps
from reproduce.project import RESULTS
from rupture import figures, once
from rupture.commands.folder import sha256_of
from rupture.commands.making import Scope
from rupture.commands.script import with_sources
from rupture.replacing import replacing

FROM_SCRATCH = "fig2.from_scratch"
SCRIPT = "commands.sh"


class MadeBy:
    """The metadata of pictures: what draws them, and the files behind them so far."""

    def __init__(self, recipe, asked):
        self.recipe, self.asked = recipe, asked
        self.found: tuple[int, list[str]] = (0, [])

    def __iter__(self):
        if self.found[0] != len(self.asked):
            self.found = len(self.asked), sorted(self.lines())
        return iter([f"./reproduce.sh {self.recipe}", *self.found[1]])

    def lines(self):
        for work in with_sources(dict.fromkeys(self.asked)):
            found = None if work.has_report else work.making.store.result(work.own)
            for name, checksum in (found or {}).get("checksums", {}).items():
                yield f"{work.own}.{name}: content-sha256 {checksum[:16]}"


def forget():
    """What other recipes have asked for counts for this one, too."""
    ours = (one for one in list(modules.values()) if is_recipes(getattr(one, "__file__", None)))
    for function in (one for module in ours for one in vars(module).values()):
        if hasattr(function, "cache_clear"):
            function.cache_clear()


def is_recipes(file):
    return bool(file) and RECIPES in Path(file).parents


def publish(folder, place):
    """Gives files their place in results/. One that is equal keeps its date; of ours, those that
    are not written any more go."""
    files = {place / file.name: file for file in sorted(folder.iterdir())}
    take(RESULTS, *files)
    for target, file in files.items():
        if not is_intact(target, sha256_of(file)):
            with replacing(target) as part:
                shutil.copyfile(file, part)
    ours = [path for path in map(RESULTS.joinpath, written(RESULTS)) if path.parent == place]
    for path in ours:
        if path not in files:
            path.unlink(missing_ok=True)
    seal(RESULTS, *ours)


def figure_of(recipe):
    return import_module(f"{recipe.replace('/', '.')}.figure")


def draw(recipe, folder):
    """What write_claims() needs."""
    return figure_of(recipe).make(folder) or [], judge(recipe)


def make(recipe, is_whole, making):
    """Raises Failure if it cannot be made. What is known stays known."""
    store, scope = making.store, Scope(making.scope)
    refuse_others(RESULTS, RESULTS / recipe / CLAIMS)  # before hours of computing
    code = stamps.code_of(recipe, store)
    note_asked(recipe, [], store, is_finished=False)
    forget()
    Sampling.is_whole = is_whole
    figures.made_by = MadeBy(recipe, scope.asked)
    folder = store.now / "drawn" / recipe
    folder.mkdir(parents=True)
    numbers, claims = making.within(scope, draw, (recipe, folder))
    works = [work for work in dict.fromkeys(scope.asked) if store.result(work.own)]
    jobs = [*jobs_of(works)]
    write_claims(folder / CLAIMS, claims, numbers, builds_of(jobs))
    write_jobs(folder, jobs)
    script = once.script_of(works, label(recipe) or recipe, RECIPES.parent)
    (folder / SCRIPT).write_text(script, encoding="utf-8")
    publish(folder, RESULTS / recipe)
    behind = with_sources(works)
    note_asked(recipe, behind, store)
    inputs = sorted({str(path) for work in behind for path in work.stamps})
    files = code | stamps.described(inputs, store)
    stamps.save(recipe, files, [own for own in scope.lacks if not store.result(own)], store)


def note_asked(recipe, works, store, is_finished=True):
    """Which results it needs; those of before, too, until it is finished."""
    name = stamps.record_of(recipe, stamps.ASKED)
    before = () if is_finished else (store.result(name, stamps.NEEDS) or {}).get("asked", ())
    asked = {"asked": [*before, *(work.own for work in works)], "is_finished": is_finished}
    store.save(name, asked)


def check_from_scratch(making):
    """Checkpoints that are shipped must come out as they are. Raises Failure if one does not."""
    Sampling.is_whole, scope = True, Scope(making.scope)
    making.within(scope, import_module(FROM_SCRATCH).check, ())
    note_asked("from-scratch", with_sources(dict.fromkeys(scope.asked)), making.store)


def show(recipe, is_whole):
    """Prints the commands that would run, as far as one knows them; returns whether it does."""
    forget()
    Sampling.is_whole = is_whole
    with TemporaryDirectory() as folder:
        results = Path(folder, recipe)
        results.mkdir(parents=True)
        steps = [partial(figure_of(recipe).make, results)]
        steps += [partial(claim_of, row, {}) for row in rows_of(recipe)]
        return all([is_told(step) for step in steps])


def is_told(step):
    try:
        step()
    except once.Unknown:
        return False
    return True
