"""Writes results/ro-crate-metadata.json: -m report.crate [PROJECT'S FOLDER]

It says what is in results/ and how it was made, for programs and archives: files, checksums,
versions, commands and times as RO-Crate 1.1 (https://w3id.org/ro/crate/1.1). Paths are relative to
results/, so that the folder may be copied alone. Equal results give equal texts, except for dates.
"""

import hashlib
import json
import sys
import time
from datetime import datetime, timezone
from mimetypes import MimeTypes
from pathlib import Path
from urllib.parse import quote

import yaml

from chains.ini import new_ini
from measure.tables import read_table
from reproduce.written import take
from rupture.errors import Failure
from rupture.replacing import write_whole
from claims.released import version_of
from report.origin import Accounts, builds, checksums
from claims.recipes import read_readme, recipe_names

CITATION = Path(__file__).resolve().parents[2] / "CITATION.cff"
CRATE = "ro-crate-metadata.json"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
CONTEXT = [f"{SPECIFICATION}/context", {"sha256": "http://schema.org/sha256"}]
SOFTWARE = "#rupture"
FORMATS = MimeTypes()  # Python's own table, whatever the machine has
FORMATS.types_map[True][".jsonl"] = "application/jsonl"
# Files of the whole run, with what they are. Those that hold times have no checksum here, the
# pictures have one instead.
OF_THE_RUN: dict[str, str | None] = {
    "index.html": "All figures and claims on one page",
    "jobs.jsonl": "Each job that was run: rule, command, inputs, outputs, start and time",
    "runs.jsonl": "Each call of ./reproduce.sh: recipes, cores, start and time",
    "numbers.csv": "The paper's numbers beside ours",
    **dict.fromkeys(("claims.pdf", "claims.png")),
}


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


def software():
    """With its licence and the paper, from CITATION.cff."""
    cited = yaml.safe_load(CITATION.read_text(encoding="utf-8"))
    paper = cited["references"][0]
    article = entity(paper["url"], "ScholarlyArticle", name=paper["title"])
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
        citation=article,
    )


def program(number, text):
    """`text` is that of origin.builds()."""
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
    content = path.read_bytes()
    digest = hashlib.sha256(content).hexdigest()
    return file_entity(results, path, contentSize=str(len(content)), sha256=digest)


def points_of(folder):
    """The results of the points in the table of a user's sweep."""
    table = folder / f"{folder.name}.csv"
    names = read_table(table)["point"] if table.exists() else ()
    return [f"results/data/points/{name}.json" for name in names]


def described(root, name):
    """Title, commands, and what one types: of a recipe, or of a user's sweep."""
    if not name.startswith("sweeps/"):
        readme = read_readme(root / "recipes" / name / "README.md")
        return readme.title, readme.commands, f"./reproduce.sh {name}"
    stem, ini = name.removeprefix("sweeps/"), new_ini()
    ini.read(root / "results" / name / f"{stem}.ini", encoding="utf-8")
    lines = [f"{key} = {line}" for key, line in ini["commands"].items()]
    title = ini.get("sweep", "title", fallback=stem)
    return title, "\n".join(lines), f"./reproduce.sh sweep {stem}.ini"


def run_of(root, name, accounts, source, built):
    """A recipe or sweep that has results: what they were made from, and its folder. `built` are
    programs by the texts of origin.builds()."""
    results = root / "results"
    behind = accounts.files_behind(name, points_of(results / name) if "sweeps/" in name else ())
    title, commands, typed = described(root, name)
    paths = sorted(path for path in (results / name).glob("[!.]*") if path.is_file())
    files = [whole_file(results, path) for path in paths if path.suffix != ".part"]
    checkpoints = [  # and records, by the checksums of their content
        file_entity(results, results / "data" / each, identifier=f"content-sha256:{checksum}")
        for each, checksum in checksums(root, behind)
        if (results / "data" / each).exists()
    ]
    programs = [
        built.setdefault(text, program(len(built) + 1, text))
        for text, _ in sorted(builds(root, behind))
    ]
    jobs = accounts.jobs(behind)
    return entity(
        f"#run-{quote(name)}",
        "CreateAction",
        name=typed,
        description=commands,
        startTime=jobs and moment(jobs[0]["started"]),
        endTime=jobs and moment(max(job["started"] + job["seconds"] for job in jobs)),
        instrument=[source, *programs],
        object=checkpoints,
        result=[entity(f"{quote(name)}/", "Dataset", name=title, hasPart=files), *files],
    )


def crate(root, now):
    """The JSON-LD: a flat list of entities."""
    results, source, accounts = root / "results", software(), Accounts(root)
    sweeps = sorted(path.parent.name for path in results.glob("sweeps/*/*.ini"))
    names = [*recipe_names(root), *(f"sweeps/{name}" for name in sweeps)]
    names = [name for name in names if (results / name).is_dir()]
    built: dict[str, dict] = {}
    runs = [run_of(root, name, accounts, source, built) for name in names]
    folders = [run["result"][0] for run in runs]
    if checkpoints := {each["@id"]: each for run in runs for each in run["object"]}:
        title = "Checkpoints and records, with the checksums of their content"
        folders.append(entity("data/", "Dataset", name=title, hasPart=[*checkpoints.values()]))
    files = [
        file_entity(results, path, description=text) if text else whole_file(results, path)
        for name, text in OF_THE_RUN.items()
        if (path := results / name).exists()
    ]
    top = entity(
        "./",
        "Dataset",
        name=f"Results of {source['name']}",
        description="Figures, claims with their verdicts, and checkpoints, as ./reproduce.sh"
        " computed them to compare with the paper.",
        datePublished=moment(now),
        license=source["license"],
        citation=source["citation"],
        hasPart=folders + files,
        mentions=runs,
    )
    graph: dict[str, dict] = {}
    about = {"conformsTo": {"@id": SPECIFICATION}, "about": {"@id": "./"}}
    flat([entity(CRATE, "CreativeWork", **about), top, source], graph)
    return {"@context": CONTEXT, "@graph": [*graph.values()]}


def write_crate(root):
    text = json.dumps(crate(root, time.time()), indent=1, ensure_ascii=False)
    write_whole(root / "results" / CRATE, text + "\n")


if __name__ == "__main__":
    folder = Path(*sys.argv[1:]).resolve()
    results = (folder / "results").resolve()
    try:
        take(results, results / CRATE)
    except Failure as problem:
        sys.exit(f"crate: {problem}")
    write_crate(folder)
