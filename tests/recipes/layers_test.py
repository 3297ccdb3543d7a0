"""Modules of recipes/ import only from below, and what is below the recipes names none of them."""

import ast

import pytest

from claims.recipes import recipe_names
from claims.table import table
from conftest import ROOT

RECIPES = ROOT / "recipes"
LAYERS = ("measure", "claims", "recipes", "report", "chains", "reproduce")  # from below
PACKAGES = [layer for layer in LAYERS if layer != "recipes"]
MODULES = sorted(path for path in RECIPES.rglob("*.py"))
BELOW = [ROOT / "python/rupture", RECIPES / "measure", RECIPES / "claims"]
# Whose samples they are; and where the first paper's are.
NAMES = {*recipe_names(ROOT), *table()}


def layer_of(name):
    """Of a module, as one imports it; -1 of the package rupture and of what is not ours."""
    first = name.partition(".")[0]
    if first in PACKAGES:
        return LAYERS.index(first)
    is_recipe = (RECIPES / first).is_dir() or (RECIPES / f"{first}.py").exists()
    return LAYERS.index("recipes") if is_recipe else -1


def imported(path):
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.Import):
            yield from (one.name for one in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{path}: an import relative to it"
            yield str(node.module)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(RECIPES)))
def test_a_module_imports_only_from_below(path):
    own = layer_of(path.relative_to(RECIPES).with_suffix("").as_posix().replace("/", "."))
    assert [name for name in imported(path) if layer_of(name) > own] == []


def test_the_package_imports_nothing_of_recipes():
    for path in (ROOT / "python/rupture").rglob("*.py"):
        assert [name for name in imported(path) if layer_of(name) >= 0] == []


def texts_in(path):
    """Those of the code, without docstrings."""
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


def test_nothing_below_the_recipes_knows_a_recipe_or_a_claim_by_name():
    for path in (path for folder in BELOW for path in folder.rglob("*.py")):
        assert NAMES.intersection(texts_in(path)) == set(), path
