"""The claims of a paper and when each is accepted, as the file beside its recipes says."""

import tomllib
from functools import cache
from itertools import chain
from pathlib import Path

from rupture.errors import Failure

from claims.recipes import RECIPES, paper_of
from measure.ways import WAYS, others


@cache
def read(paper):
    """What a paper is, and {recipe: {claim: its row}}."""
    path = RECIPES / paper / "claims.toml"
    try:
        recipes = tomllib.loads(path.read_text(encoding="utf-8"))
        return recipes.pop("paper"), recipes
    except (OSError, KeyError, ValueError) as error:
        raise Failure(f"The claims in {path} cannot be read ({error}).") from error


@cache
def table(paper=""):
    """{claim id: its row, with its id and recipe}, of another paper PAPER/2A and PAPER/fig2. A row
    has all of the one that it is like, except for what it says itself."""
    found: dict[str, dict] = {}
    for recipe, rows in read(paper)[1].items():
        for name, row in rows.items():
            name, like, of = (str(Path(paper, n)) for n in (name, row.get("like", "-"), recipe))
            found[name] = found.get(like, {}) | row | {"id": name, "recipe": of}
    return found


def samples_from(recipe):
    """The recipe that computes the samples of the others of its paper; None if each computes its
    own."""
    name = read(paper_of(recipe))[0].get("samples")
    return name and str(Path(paper_of(recipe), name))


def row_of(claim_id):
    return table(paper_of(claim_id))[claim_id]


def rows_of(recipe):
    return [row for row in table(paper_of(recipe)).values() if row["recipe"] == recipe]


def ways_of(row):
    """Names of the ways to measure, beside the primary one."""
    out = tuple(row.get("left_out", ()))
    of_fronts = [way for way in others(WAYS) if not way.startswith(out)]
    named = ([name] if name != "fronts" else of_fronts for name in row.get("ways", ()))
    return [*chain(*named)]


def left_out(row):
    """Says which ways to measure a front a row leaves out, and why."""
    texts = [f"{way or 'all'}: {why}" for way, why in row.get("left_out", {}).items()]
    return f"Ways to measure that are left out: {'; '.join(texts)}." if texts else ""
