#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Writes results/index.html, one page with all figures and claims: report.py [PROJECT'S FOLDER]

Shows what is there and says how to compute the rest. Needs results/NAME/ of any number of recipes.
Programs can read the same in the file that crate.py writes.
"""

import struct
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from caption import NOT_RUN, filled
from claims.claim import VERDICTS, Claim, measured_parts, read_claims
from claims.own_result import read_own
from data.replacing import write_whole
from crate import write_crate
from glance import draw_glance
from jobs import Accounts, Job, steps, total
from origin import builds, checksums, last_run, present_build, processor
from project import Problem, Readme, as_html, listed_claims, natural, read_readme, recipe_names

HERE = Path(__file__).resolve().parent
MANY = 12  # commands of a step, or checksums, beyond which only their number is of interest
MANY_SUMS = 100


@dataclass(frozen=True)
class Picture:
    name: str
    pdf: str | None
    width: int  # [pixels]
    height: int


@dataclass(frozen=True)
class Recipe:
    name: str
    readme: Readme
    caption: str  # HTML
    claims: list[Claim] | None  # None: not computed yet
    pictures: list[Picture]
    tables: list[str]
    jobs: list[Job]
    sums: list[tuple[str, str]]


# --- results of a recipe -------------------------------------------------------------------


def claims_of(root, name):
    path = root / "results" / name / "claims.json"
    if not path.exists():
        return None
    try:
        return read_claims(path)
    except (OSError, ValueError, TypeError) as error:
        raise Problem(
            f"{path} holds no table of claims ({error}): delete it and run ./reproduce.sh {name}."
        ) from error


def picture(path):
    """Width and height stand in a PNG after its signature and the name of the first chunk."""
    with open(path, "rb") as file:
        head = file.read(24)
    if len(head) < 24 or head[12:16] != b"IHDR":
        raise Problem(f"{path} is no PNG: delete it and run ./reproduce.sh {path.parent.name}.")
    width, height = struct.unpack(">II", head[16:24])
    pdf = path.with_suffix(".pdf")
    return Picture(path.name, pdf.name if pdf.exists() else None, width, height)


def files_of(root, name, pattern):
    return sorted((root / "results" / name).glob(pattern), key=lambda path: natural(path.name))


def read_recipe(root, name, accounts):
    readme = read_readme(root / "recipes" / name / "README.md")
    claims = claims_of(root, name)
    numbers = (claims or []) + read_own(root / "results" / name)
    files = accounts.files_behind(name)
    return Recipe(
        name=name,
        readme=readme,
        caption=as_html(filled(readme.caption, numbers), f"../recipes/{name}"),
        claims=claims,
        pictures=[picture(path) for path in files_of(root, name, "*.png")],
        tables=[path.name for path in files_of(root, name, "*.csv")],
        jobs=accounts.jobs(files),
        sums=checksums(root, files),
    )


# --- all claims ----------------------------------------------------------------------------


def results_by_id(recipes, listed):
    """{claim id: (name of its recipe, claim)}"""
    known = {claim.id for claim in listed}
    found = {}
    for recipe in recipes:
        for claim in recipe.claims or []:
            path = f"results/{recipe.name}/claims.json"
            if claim.id not in known:
                raise Problem(f"{path} has a claim '{claim.id}' that claims.toml does not list.")
            if claim.id in found:
                raise Problem(f"Claim '{claim.id}' is in {path} although it was found before.")
            found[claim.id] = recipe.name, claim
    return found


def summary_rows(listed, results):
    rows = []
    for claim in listed:
        recipe, result = results.get(claim.id, (claim.recipe, None))
        verdict = result.verdict if result else NOT_RUN
        reason = result.reason if result else ""
        rows.append({"listed": claim, "recipe": recipe, "verdict": verdict, "reason": reason})
    return rows


def counts(rows):
    names = (*VERDICTS, NOT_RUN)
    return [(sum(row["verdict"] == name for row in rows), name) for name in names]


def draw_claims(root, recipes):
    """results/claims.png, all claims at a glance; False without any claim over units."""
    found = [claim for recipe in recipes for claim in recipe.claims or [] if claim.shares]
    if found:
        draw_glance(found, root / "results/claims")
    return bool(found)


# --- the page ------------------------------------------------------------------------------


def duration(seconds):
    if seconds < 10:
        return f"{seconds:.1f} s"
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds // 60:.0f} min {seconds % 60:.0f} s"


def css_class(verdict):
    return verdict.replace(" ", "-")


def contents(root):
    accounts = Accounts(root)
    listed = listed_claims(root)
    names = recipe_names(root)
    recipes = [read_recipe(root, name, accounts) for name in names]
    rows = summary_rows(listed, results_by_id(recipes, listed))
    files = set().union(*(accounts.files_behind(name) for name in names))
    jobs = accounts.jobs(files)
    return {
        "recipes": recipes,
        "rows": rows,
        "counts": counts(rows),
        "glance": picture(root / "results/claims.png") if draw_claims(root, recipes) else None,
        "jobs": jobs,
        "run": last_run(root, jobs),
        "builds": builds(root, files),
        "build": present_build(root),
        "processor": processor(),
    }


def render(content):
    environment = Environment(
        loader=FileSystemLoader(HERE),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(
        css_class=css_class,
        date=lambda moment: time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime(moment)),
        duration=duration,
        measured_parts=measured_parts,
        steps=steps,
        total=total,
    )
    environment.globals.update(MANY=MANY, MANY_SUMS=MANY_SUMS, NOT_RUN=NOT_RUN)
    return environment.get_template("page.html.j2").render(content)


def main(folder="."):
    root = Path(folder).resolve()
    path = root / "results/index.html"
    try:
        write_whole(path, render(contents(root)))
        write_crate(root)
    except Problem as problem:
        sys.exit(f"report.py: {problem}")
    print(f"Report: {path}")


if __name__ == "__main__":
    main(*sys.argv[1:])
