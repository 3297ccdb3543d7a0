"""Writes results/index.html, one page with all figures and claims: -m report.page
[PROJECT'S FOLDER]"""

import os
import struct
import sys
from collections import Counter
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.caption import as_html, filled, seen
from claims.claim import CLAIMS, DIFFERS, HOLDS, STANDINGS, VERDICTS, number, read_results
from claims.table import read, rows_of, table
from claims.own_result import results_in
from claims.released import released, version_of
from rupture.commands.folder import open_own
from rupture.replacing import write_whole
from report.readme import update_readme, write_numbers
from report.crate import CRATE, write_crate
from report.glance import SEEN, draw_glance
from report import jobs as of_jobs
from claims.recipes import label, natural, paper_of, read_readme, recipe_names
from rupture.errors import Failure
from report.written import intact, leave_out, seal, take, written
from report.symbols import typeset

HERE = Path(__file__).resolve().parent
GLANCE = ("claims.png", "claims.pdf")
WRITTEN = ("index.html", "numbers.csv", *GLANCE)
COMMANDS = "commands.sh"  # all of a recipe, by hand
MOVIE = "fig2/movie.gif"  # of a slow front; the page begins with it


def picture(path, alt):
    """The files of a picture, its size in pixels, and what is seen, in words. Width and height
    stand in a PNG after its signature and the name of the first chunk."""
    with open_own(path) as file:
        head = file.read(24)
    if len(head) < 24 or head[12:16] != b"IHDR":
        raise Failure(f"{path} is not a PNG")
    size = dict(zip(("width", "height"), struct.unpack(">II", head[16:24])))
    pdf = path.with_suffix(".pdf")
    return size | {"name": path.name, "pdf": pdf.name if pdf.exists() else None, "alt": alt}


def first_own(paths):
    """The one with the name of the recipe comes first."""
    return sorted(paths, key=lambda path: (path.stem != path.parent.name, natural(path.name)))


class Recipe:
    """A recipe with results, for its section; `shown` are all recipes that have a section. Raises
    Failure if its results are not as they were written."""

    def __init__(self, root, name, shown):
        results = root / "results"
        folder, paths = results / name, intact(results, name)
        readme = read_readme(root / "recipes" / name / "README.md")
        self.name = folder.name  # beside the page
        self.label = label(name)  # none if it belongs to no figure
        self.title, self.commands = readme.title, readme.commands
        self.claims, self.numbers, _ = read_results(folder / CLAIMS)
        check_listed(folder / CLAIMS, self.claims, rows_of(name))
        self.own = results_in(folder)
        self.files = {path.name for path in paths}
        caption = filled(readme.caption, self.claims + self.own)
        self.caption = as_html(caption, shown)
        self.pictures = [
            picture(path, seen(path.name, readme.title, caption))
            for path in first_own(paths)
            if path.suffix == ".png"
        ]
        self.tables = [path.name for path in first_own(paths) if path.suffix == ".csv"]
        self.accounts = [name for name in (COMMANDS, of_jobs.JOBS) if name in self.files]
        self.jobs = of_jobs.read_jobs(folder)


def check_listed(path, claims, rows):
    """Raises Failure for claims that claims.toml does not list there, or that are there twice."""
    listed = [row["id"] for row in rows]
    for claim in claims:
        if claim.id not in listed:
            raise Failure(f"{path} has a claim '{claim.id}' more than claims.toml lists")
        listed.remove(claim.id)


def with_results(root):
    ours = written(root / "results")
    return [name for name in recipe_names(root) if f"{name}/{CLAIMS}" in ours]


def shown_of(root, names):
    """Those of which all results are as they were written."""
    found = []
    for name in names:
        with leave_out(name):
            found.append(Recipe(root, name, [Path(one).name for one in names]))
    return found


def glance_picture(results, claims):
    """Draws the picture of all claims over samples; None if there is none."""
    found = [claim for claim in claims if claim.shares]
    if not found:
        return None
    draw_glance(found, results / "claims")
    return picture(results / GLANCE[0], SEEN)


def in_words(claims):
    """What came out: verdicts, and how many findings without one hold as they are shown."""
    findings = [claim for claim in claims if claim.kind == "finding"]
    judged = [claim for claim in findings if claim.verdict]
    shown = [claim.shown for claim in findings if not claim.verdict and claim.shown]
    texts = []
    if judged:
        count = Counter(claim.verdict for claim in judged)
        words = ", ".join(f"{count[word]} {word}" for word in VERDICTS if count[word])
        differ = [f"{one.id} ({one.paper})" for one in judged if one.verdict == DIFFERS]
        texts.append(f"Findings of the paper with a verdict: {len(judged)}, of which {words}.")
        texts += [f"What differs: {'; '.join(differ)}."] if differ else []
    if shown:
        text = f"Without a verdict, {shown.count(HOLDS)} of {len(shown)} hold for what is shown"
        texts.append(f"{text}: one event or set; a verdict needs other runs.")
    return " ".join(texts)


def contents(root, paper):
    results = root / "results" / paper
    names = [name for name in with_results(root) if paper_of(name) == paper]
    recipes = shown_of(root, names)
    shown = [recipe.name for recipe in recipes]
    found = {claim.id: (recipe, claim) for recipe in recipes for claim in recipe.claims}
    rows = [found[claim_id] for claim_id in table(paper) if claim_id in found]
    claims = [claim for _, claim in rows]
    jobs = [*{job["id"]: job for recipe in recipes for job in recipe.jobs}.values()]
    builds = of_jobs.builds_of(jobs)
    verdicts = (root / "docs/claims.md").read_text(encoding="utf-8").partition("\n")[2]
    if paper:  # what follows is about the claims of the first one
        verdicts = verdicts.partition("## When ")[0]
    return {
        "paper": read(paper)[0],
        "recipes": recipes,
        "rows": rows,
        "listed": len(table(paper)),
        "in_words": in_words(claims),
        "counts": [
            (kind, [(sum((c.kind, c.standing) == (kind, s) for c in claims), s) for s in STANDINGS])
            for kind in ("finding", "check")
        ],
        "numbers": [number for recipe in recipes for number in recipe.numbers],
        "released": released(root, builds),
        "movie": any(MOVIE == f"{one.name}/{file}" for one in recipes for file in one.files)
        and MOVIE,
        "glance": glance_picture(results, claims),
        "verdicts": as_html(verdicts, shown),
        "builds": builds,
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
        number=number,
        typeset=typeset,
    )
    return environment.get_template("page.html.j2").render(content)


def write_page(root, results, paper):
    """Returns what it shows."""
    path = results / paper / "index.html"
    take(results, *map(path.with_name, WRITTEN))
    content = contents(root, paper)
    write_whole(path, render(content))
    write_numbers(path.with_name("numbers.csv"), content["numbers"])
    for name in () if content["glance"] else GLANCE:
        path.with_name(name).unlink(missing_ok=True)  # of other results
    seal(results, *map(path.with_name, WRITTEN))
    return content


def main(folder="."):
    root = Path(folder).resolve()
    results = (root / "results").resolve()
    try:
        take(results, results / CRATE)
        papers = sorted({"", *map(paper_of, with_results(root))})
        content, *_ = [write_page(root, results, paper) for paper in papers]
        write_crate(root)
        if len(content["rows"]) == len(table()):
            own = [result for recipe in content["recipes"] for result in recipe.own]
            claims = [claim for _, claim in content["rows"]]
            main_build = next((build for build, _ in content["builds"]), "")  # of most records
            version = version_of(main_build)
            update_readme(root, claims, own, content["numbers"], version)
        for paper in papers:
            print(f"Report: {results / paper / 'index.html'}", flush=True)
    except Failure as problem:
        sys.exit(f"report: {problem}")
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Python tries once more
        sys.exit(f"report: {error.filename or 'standard output'}: {error.strerror}.")


if __name__ == "__main__":
    main(*sys.argv[1:])
