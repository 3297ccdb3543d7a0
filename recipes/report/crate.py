"""Writes results/ro-crate-metadata.json: -m report.crate [PROJECT'S FOLDER]

It says what is in results/ and how it was made, for programs and archives: files, checksums,
versions, commands and times as RO-Crate 1.1 (https://w3id.org/ro/crate/1.1). Paths are relative to
results/, so that the folder may be copied alone. Equal results give equal texts, except for dates.
"""

import json
import sys
import time
from datetime import datetime, timezone
from mimetypes import MimeTypes
from pathlib import Path
from urllib.parse import quote

import yaml

from claims.claim import CLAIMS
from claims.recipes import paper_of, read_readme, recipe_names
from claims.released import version_of
from claims.table import read
from report.jobs import JOBS, builds_of, files_of, read_jobs
from report.written import intact, is_intact, leave_out, seal, take, written
from rupture.commands.folder import sha256_of
from rupture.commands.store import place_of
from rupture.errors import Failure
from rupture.replacing import write_whole

CITATION = Path(__file__).resolve().parents[2] / "CITATION.cff"
CRATE = "ro-crate-metadata.json"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
CONTEXT = [f"{SPECIFICATION}/context", {"sha256": "http://schema.org/sha256"}]
SOFTWARE = "#rupture"
FORMATS = MimeTypes()  # Python's own table, whatever the machine has
FORMATS.types_map[True][".jsonl"] = "application/jsonl"
# What files are that hold times, and so have no checksum here.
WITH_TIMES = {
    "index.html": "All figures and claims on one page",
    JOBS: "Each command behind the results: its words, inputs, checksums, start and time",
}
OF_THE_RUN = ("index.html", "numbers.csv", "claims.pdf", "claims.png")


def entity(identity, kind, **properties):
    return {"@id": identity, "@type": kind, **properties}


def flat(value, graph):
    """The value of a property. For an entity, this is a reference; the entity itself, with what is
    nested in it and without empty properties, joins the graph: {id: entity}."""
    if isinstance(value, list):
        return [flat(each, graph) for each in value]
    if not isinstance(value, dict):
        return value
    identity = value["@id"]
    if len(value) > 1 and identity not in graph:
        graph[identity] = {}  # comes before what is nested in it
        graph[identity] = {name: flat(one, graph) for name, one in value.items() if one}
    return {"@id": identity}


def moment(seconds):
    """Writes seconds since 1970 as ISO 8601."""
    return datetime.fromtimestamp(int(seconds), timezone.utc).isoformat()


# --- the programs and the paper ------------------------------------------------------------


def article(paper):
    return entity(paper["url"], "ScholarlyArticle", name=paper["title"])


def software():
    """Rupture itself with its licence and the paper, from CITATION.cff."""
    cited = yaml.safe_load(CITATION.read_text(encoding="utf-8"))
    licence = entity(
        f"https://spdx.org/licenses/{cited['license']}",
        "CreativeWork",
        name=f"{cited['license']} License",
    )
    return entity(
        SOFTWARE,
        "SoftwareSourceCode",
        name=cited["title"],
        version=cited["version"],
        description=cited["abstract"],
        keywords=cited["keywords"],
        programmingLanguage=["C++", "Python"],
        operatingSystem="Linux",
        author=[
            entity(f"#{quote(one['name'].replace(' ', '-'))}", "Organization", name=one["name"])
            for one in cited["authors"]
        ],
        license=licence,
        citation=article(cited["references"][0]),
    )


def program(number, text):
    """`text` is that of builds_of()."""
    return entity(
        f"#programs-{number}",
        "SoftwareApplication",
        name="rupture's programs",
        version=version_of(text),
        description=text,
    )


# --- files and recipes ---------------------------------------------------------------------


def file_entity(results, path, **properties):
    name = str(path.relative_to(results))
    kind = FORMATS.guess_type(name)[0]
    return entity(quote(name), "File", name=path.name, encodingFormat=kind, **properties)


def whole_file(results, path):
    if path.name in WITH_TIMES:
        return file_entity(results, path, description=WITH_TIMES[path.name])
    size = str(path.stat().st_size)
    return file_entity(results, path, contentSize=size, sha256=sha256_of(path))


def described(root, name):
    """Title, commands, and what one types: of a recipe, or of a user's sweep, whose file has the
    commands."""
    if not name.startswith("sweeps/"):
        readme = read_readme(root / "recipes" / name / "README.md")
        return readme.title, readme.commands, f"./reproduce.sh {name}"
    stem = name.removeprefix("sweeps/")
    return f"Sweep {stem}", "", f"./reproduce.sh sweep {stem}.ini"


def checkpoints_of(results, jobs):
    """The checkpoints and records that the store keeps, by the checksums of their content."""
    places = ((results / "store" / place_of(own, name), sum) for own, name, sum in files_of(jobs))
    return [
        file_entity(results, path, identifier=f"content-sha256:{checksum}")
        for path, checksum in places
        if path.is_file() and not path.is_symlink()
    ]


def run_of(root, name, source, built):
    """A recipe or sweep that has results: what they were made from, and its folder. `built` are
    programs by the texts of builds_of()."""
    results = root / "results"
    paths = intact(results, name)
    title, commands, typed = described(root, name)
    files = [whole_file(results, path) for path in paths]
    jobs = read_jobs(results / name)
    programs = [
        built.setdefault(text, program(len(built) + 1, text)) for text, _ in sorted(builds_of(jobs))
    ]
    times = [
        (job["started"], job["started"] + job.get("seconds", 0)) for job in jobs if "started" in job
    ]
    return entity(
        f"#run-{quote(name)}",
        "CreateAction",
        name=typed,
        description=commands,
        startTime=times and moment(min(begin for begin, _ in times)),
        endTime=times and moment(max(end for _, end in times)),
        instrument=[source, *programs],
        object=checkpoints_of(results, jobs),
        result=[entity(f"{quote(name)}/", "Dataset", name=title, hasPart=files), *files],
    )


def crate(root, now):
    """The JSON-LD: a flat list of entities."""
    results, source = root / "results", software()
    ours = written(results)
    sweeps = sorted({str(Path(name).parent) for name in ours if Path(name).match("sweeps/*/*.ini")})
    recipes = [name for name in recipe_names(root) if f"{name}/{CLAIMS}" in ours]
    built: dict[str, dict] = {}
    runs = []
    for name in (*recipes, *sweeps):
        with leave_out(name):
            runs.append(run_of(root, name, source, built))
    folders = [run["result"][0] for run in runs]
    if checkpoints := {each["@id"]: each for run in runs for each in run["object"]}:
        title = "Checkpoints and records, with the checksums of their content"
        folders.append(entity("store/", "Dataset", name=title, hasPart=[*checkpoints.values()]))
    paths = [results / name for name in OF_THE_RUN if is_intact(results / name, ours.get(name))]
    top = entity(
        "./",
        "Dataset",
        name=f"Results of {source['name']}",
        description="Figures, claims with their verdicts, and checkpoints, as ./reproduce.sh"
        " computed them to compare with papers.",
        datePublished=moment(now),
        license=source["license"],
        citation=[article(read(paper)[0]) for paper in dict.fromkeys(map(paper_of, recipes))],
        hasPart=folders + [whole_file(results, path) for path in paths],
        mentions=runs,
    )
    graph: dict[str, dict] = {}
    about = {"conformsTo": {"@id": SPECIFICATION}, "about": {"@id": "./"}}
    flat([entity(CRATE, "CreativeWork", **about), top, source], graph)
    return {"@context": CONTEXT, "@graph": [*graph.values()]}


def write_crate(root):
    results = root / "results"
    take(results, results / CRATE)
    text = json.dumps(crate(root, time.time()), indent=1, ensure_ascii=False)
    write_whole(results / CRATE, text + "\n")
    seal(results, results / CRATE)


if __name__ == "__main__":
    try:
        write_crate(Path(*sys.argv[1:]).resolve())
    except Failure as problem:
        sys.exit(f"crate: {problem}")
