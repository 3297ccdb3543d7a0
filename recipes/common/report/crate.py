#!/usr/bin/env python3
"""Writes results/ro-crate-metadata.json: crate.py [PROJECT'S FOLDER]

It says what is in results/ and how it was made, for programs and archives: files, checksums,
versions, commands and times as RO-Crate 1.1 (https://w3id.org/ro/crate/1.1). Paths are relative to
results/, so that the folder may be copied alone. Equal results give equal texts but for dates.
"""

import hashlib
import json
import re
import sys
import time
from datetime import datetime, timezone
from mimetypes import MimeTypes
from pathlib import Path
from urllib.parse import quote

import yaml

from runs.written import take_names
from rupture.replacing import write_whole
from origin import Accounts, builds, checksums
from picture import ANIMATION, VIDEOS
from runs.recipes import read_readme, recipe_names

CITATION = Path(__file__).resolve().parents[3] / "CITATION.cff"
CRATE = "ro-crate-metadata.json"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
CONTEXT = [f"{SPECIFICATION}/context", {"sha256": "http://schema.org/sha256"}]
SOFTWARE = "#rupture"
FORMATS = MimeTypes()  # Python's own table, whatever the machine has
FORMATS.types_map[True][".jsonl"] = "application/jsonl"
# Files of the whole run; those that hold times have no checksum here.
OF_THE_RUN = {
    "index.html": "All figures and claims on one page",
    "jobs.jsonl": "Each job that was run: rule, command, inputs, outputs, start and time",
    "runs.jsonl": "Each call of ./reproduce.sh: recipes, cores, start and time",
}
OF_THE_PAGE = ("claims.pdf", "claims.png", *VIDEOS, ANIMATION)


def entity(identity, kind, **properties):
    """Without the properties that are None or empty."""
    known = {name: value for name, value in properties.items() if value}
    return {"@id": identity, "@type": kind, **known}


def references(entities):
    return [{"@id": each["@id"]} for each in entities]


def moment(seconds):
    """Of seconds since 1970, as ISO 8601."""
    return datetime.fromtimestamp(int(seconds), timezone.utc).isoformat()


# --- the programs and the paper ------------------------------------------------------------


def named(kind, name, **properties):
    return entity(f"#{quote(name.replace(' ', '-'), safe='')}", kind, name=name, **properties)


def origin_of_results():
    """Entities of the programs, the licence, the paper and all authors, from CITATION.cff."""
    cited = yaml.safe_load(CITATION.read_text(encoding="utf-8"))
    paper = cited["references"][0]
    people = [
        named("Person", f"{given} {family}", givenName=given, familyName=family)
        for given, family in ((one["given-names"], one["family-names"]) for one in paper["authors"])
    ]
    journal = named("Periodical", paper["journal"])
    article = entity(
        paper["url"],
        "ScholarlyArticle",
        name=paper["title"],
        author=references(people),
        isPartOf={"@id": journal["@id"]},
        datePublished=str(paper["year"]),
    )
    authors = [named("Organization", author["name"]) for author in cited["authors"]]
    licence = entity(
        f"https://spdx.org/licenses/{cited['license']}",
        "CreativeWork",
        name=f"{cited['license']} License",
        description="Free to use, change and pass on, with the notice of the licence",
    )
    software = entity(
        SOFTWARE,
        "SoftwareSourceCode",
        name=cited["title"],
        version=cited["version"],
        description=cited["abstract"],
        keywords=cited["keywords"],
        programmingLanguage=["C++", "Python"],
        operatingSystem="Linux",
        author=references(authors),
        license={"@id": licence["@id"]},
        citation={"@id": article["@id"]},
    )
    return [software, licence, article, journal, *people, *authors]


def build(number, text):
    """`text` is that of origin.builds()."""
    version = re.match(r"rupture ([^,]+), ", text)
    return entity(
        f"#programs-{number}",
        "SoftwareApplication",
        name="rupture's programs",
        version=version and version[1],
        description=text,
    )


# --- files ---------------------------------------------------------------------------------


def file_entity(results, path, **properties):
    return entity(
        quote(str(path.relative_to(results))),
        "File",
        name=path.name,
        encodingFormat=FORMATS.guess_type(path.name)[0],
        **properties,
    )


def whole_file(results, path):
    content = path.read_bytes()
    digest = hashlib.sha256(content).hexdigest()
    return file_entity(results, path, contentSize=str(len(content)), sha256=digest)


def folder_entity(name, title, files):
    return entity(f"{quote(name)}/", "Dataset", name=title, hasPart=references(files))


def checkpoints_behind(results, files):
    """Checkpoints and records, by the checksums of their content."""
    return [
        file_entity(results, results / "data" / name, identifier=f"content-sha256:{checksum}")
        for name, checksum in checksums(results.parent, files)
        if (results / "data" / name).exists()
    ]


def files_of_run(results):
    described = [
        file_entity(results, results / name, description=text)
        for name, text in OF_THE_RUN.items()
        if (results / name).exists()
    ]
    pictures = [results / name for name in OF_THE_PAGE if (results / name).exists()]
    return described + [whole_file(results, path) for path in pictures]


# --- recipes -------------------------------------------------------------------------------


def times(jobs):
    if not jobs:
        return {}
    end = max(job.started + job.seconds for job in jobs)
    return {"startTime": moment(jobs[0].started), "endTime": moment(end)}


class Recipe:
    """One that has results; `of_build` is {text of a build: its entity}, which grows."""

    def __init__(self, root, name, accounts, of_build):
        results = root / "results"
        readme = read_readme(root / "recipes" / name / "README.md")
        paths = sorted(path for path in (results / name).iterdir() if path.is_file())
        behind = accounts.files_behind(name)
        programs = sorted(text for text, _ in builds(root, behind))
        for text in programs:
            of_build.setdefault(text, build(len(of_build) + 1, text))
        self.files = [whole_file(results, path) for path in paths if path.suffix != ".part"]
        self.checkpoints = checkpoints_behind(results, behind)
        self.folder = folder_entity(name, readme.title, self.files)
        self.action = entity(
            f"#run-{name}",
            "CreateAction",
            name=f"./reproduce.sh {name}",
            description=readme.commands,
            **times(accounts.jobs(behind)),
            instrument=[{"@id": SOFTWARE}, *references(of_build[text] for text in programs)],
            object=references(self.checkpoints),
            result=[{"@id": self.folder["@id"]}, *references(self.files)],
        )


# --- the crate -----------------------------------------------------------------------------


def crate(root, now):
    """The JSON-LD: a flat list of entities."""
    results = root / "results"
    software, *origin = origin_of_results()
    accounts = Accounts(root)
    of_build: dict[str, dict] = {}
    names = [name for name in recipe_names(root) if (results / name).is_dir()]
    recipes = [Recipe(root, name, accounts, of_build) for name in names]
    checkpoints = {each["@id"]: each for recipe in recipes for each in recipe.checkpoints}
    folders = [recipe.folder for recipe in recipes]
    if checkpoints:
        title = "Checkpoints and records, with the checksums of their content"
        folders.append(folder_entity("data", title, checkpoints.values()))
    of_run = files_of_run(results)
    actions = [recipe.action for recipe in recipes]
    descriptor = entity(
        CRATE, "CreativeWork", conformsTo={"@id": SPECIFICATION}, about={"@id": "./"}
    )
    top = entity(
        "./",
        "Dataset",
        name=f"Results of {software['name']}",
        description="Figures, claims with their verdicts, and checkpoints, as ./reproduce.sh"
        " computed them to compare with the paper.",
        datePublished=moment(now),
        license=software["license"],
        citation=software["citation"],
        hasPart=references(folders + of_run),
        mentions=references(actions),
    )
    files = [each for recipe in recipes for each in recipe.files]
    entities = [descriptor, top, *folders, *of_run, *files, *checkpoints.values(), *actions]
    return {"@context": CONTEXT, "@graph": [*entities, *of_build.values(), software, *origin]}


def write_crate(root):
    text = json.dumps(crate(root, time.time()), indent=1, ensure_ascii=False)
    write_whole(root / "results" / CRATE, text + "\n")


if __name__ == "__main__":
    folder = Path(*sys.argv[1:]).resolve()
    try:
        take_names(folder / "results", CRATE)
    except FileExistsError as problem:
        sys.exit(f"crate.py: {problem}")
    write_crate(folder)
