"""Who may import whom: each layer only those below it, so that a change has a direction."""

import ast
import re

import pytest

from claims.recipes import paper_of, recipe_names
from claims.table import table
from conftest import ROOT
from rupture.commands.code import without_docstrings

# Lowest first.
PACKAGES = ["rupture", "measure", "claims", "a recipe", "sweeps", "report", "reproduce"]
SOURCES = [*(ROOT / "python/rupture").rglob("*.py"), *(ROOT / "recipes").rglob("*.py")]
RECIPES = recipe_names(ROOT)


def layer_of(module):
    """Of a module of ours by its full name; None for others."""
    top = module.partition(".")[0]
    if top in PACKAGES:
        return top
    names = {name.partition("/")[0] for name in RECIPES}
    shared = {path.stem for path in (ROOT / "recipes").glob("*.py")}
    return "a recipe" if top in names | shared else None


def module_of(path):
    folder = ROOT / ("python" if ROOT / "python" in path.parents else "recipes")
    return ".".join(path.relative_to(folder).with_suffix("").parts)


def imports_of(text):
    """(line, module) of each import in a module, wherever it stands."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, one.name) for one in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, "imports are absolute"
            yield node.lineno, node.module


def climbing(module, text):
    """The imports of a module that lead to a layer above its own."""
    for line, other in imports_of(text):
        own, its = layer_of(module), layer_of(other)
        if {own, its} <= {*PACKAGES} and PACKAGES.index(its) > PACKAGES.index(own):
            yield f"{module}:{line} imports {other}"


@pytest.mark.parametrize("path", SOURCES, ids=module_of)
def test_a_module_imports_only_from_its_layer_and_those_below(path):
    assert [*climbing(module_of(path), path.read_text(encoding="utf-8"))] == []


@pytest.mark.parametrize(
    "module, text, is_found",
    [
        ("measure.tables", "from claims.claim import Claim", True),
        ("rupture.figures", "from measure import fronts", True),
        ("report.crate", "from reproduce import clean", True),
        ("fig3.figure", "import events, fig2.commands, paper, numpy", False),
        ("reproduce.compute", "import sweeps.table, report.page", False),
    ],
)
def test_an_import_that_climbs_is_found(module, text, is_found):
    assert bool([*climbing(module, text)]) == is_found


def texts_in(path):
    """(line, text) of what a module says or compares with, without docstrings."""
    tree = without_docstrings(ast.parse(path.read_text(encoding="utf-8")))
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.lineno, node.value


BELOW = [path for path in SOURCES if layer_of(module_of(path)) in PACKAGES[:3]]
NAMES = {*RECIPES, *(claim for paper in {*map(paper_of, RECIPES)} for claim in table(paper))}
NAMES -= {"speeds", "places"}  # plain words, too
NAMED = re.compile(rf"(?<![\w-])({'|'.join(map(re.escape, NAMES))})(?![\w-])")


@pytest.mark.parametrize("path", BELOW, ids=module_of)
def test_what_is_below_recipes_knows_none_of_them_and_no_claim(path):
    found = ((line, NAMED.findall(text)) for line, text in texts_in(path))
    assert [one for one in found if one[1]] == []


def test_files_are_read_by_the_checked_reader_alone():
    """Only it refuses what HDF5 would follow into other files."""
    opens = re.compile(r"h5py\.File\((?![^\n]*\"w\")")
    found = {module_of(path) for path in SOURCES if opens.search(path.read_text(encoding="utf-8"))}
    assert found == {"rupture.files"}
