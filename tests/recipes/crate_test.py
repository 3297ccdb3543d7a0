"""ro-crate-metadata.json from made-up results: what RO-Crate 1.1 demands, and what it says.
CITATION.cff, from which it is: that says the same as CMakeLists.txt, LICENSE and the README."""

import json
import re
import tomllib
from hashlib import sha256
from urllib.parse import unquote

import pytest
import yaml

from conftest import ROOT
from report.crate import CRATE, crate
from fixture import BUILD, Project, png, spill

CITED = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
[PAPER] = CITED["references"]
DATES = ("datePublished", "startTime", "endTime")
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
NOW, PUBLISHED = 1.75e9, "2025-06-15T15:06:40+00:00"
LICENCE = "https://spdx.org/licenses/MIT"
FILES = ("a%20b%23.csv", "claims.json", "fig3.pdf", "fig3.png", "front.csv", "jobs.jsonl")
SAYS = [  # an entity, and what it has
    (CRATE, {"@type": "CreativeWork", "conformsTo": {"@id": SPECIFICATION}}),
    (CRATE, {"about": {"@id": "./"}}),
    ("./", {"@type": "Dataset", "datePublished": PUBLISHED, "license": {"@id": LICENCE}}),
    ("./", {"citation": [{"@id": PAPER["url"]}], "name": f"Results of {CITED['title']}"}),
    (LICENCE, {"name": "MIT License"}),
    ("fig3/a%20b%23.csv", {"name": "a b#.csv", "encodingFormat": "text/csv"}),
    ("fig3/front.csv", {"sha256": sha256(b"x\n").hexdigest(), "contentSize": "2"}),
    ("fig3/fig3.pdf", {"sha256": sha256(b"%PDF").hexdigest(), "contentSize": "4"}),
    ("fig3/fig3.png", {"sha256": sha256(png(210, 80)).hexdigest(), "encodingFormat": "image/png"}),
    ("store/ab/ab12.load.h5", {"identifier": "content-sha256:5eed5eed"}),
    ("#run-fig3", {"@type": "CreateAction", "name": "./reproduce.sh fig3"}),
    ("#run-fig3", {"description": "load -o fig3.h5 --until 1.2\nanalyze front fig3.h5"}),
    ("#run-fig3", {"startTime": "2023-11-14T22:13:20+00:00"}),
    ("#run-fig3", {"endTime": "2023-11-14T22:14:21+00:00"}),
    ("#run-fig3", {"instrument": [{"@id": "#rupture"}, {"@id": "#programs-1"}]}),
    ("#run-fig3", {"object": [{"@id": "store/ab/ab12.load.h5"}]}),
    ("#run-fig3", {"result": [{"@id": f"fig3/{name}"} for name in ("", *FILES)]}),
    ("#programs-1", {"@type": "SoftwareApplication", "version": "0.9.0"}),
    ("#programs-1", {"description": BUILD}),
    ("#rupture", {"@type": "SoftwareSourceCode", "name": CITED["title"]}),
    ("#rupture", {name: CITED[name] for name in ("version", "keywords")}),
    ("#rupture", {"description": CITED["abstract"], "author": [{"@id": "#The-rupture-authors"}]}),
    ("#rupture", {"citation": {"@id": PAPER["url"]}, "license": {"@id": LICENCE}}),
    (PAPER["url"], {"@type": "ScholarlyArticle", "name": PAPER["title"]}),
]


@pytest.fixture(name="project")
def made_up_project(tmp_path):
    return make(tmp_path / "one")


def make(root):
    project = Project(root)
    project.make_recipes()
    project.make_accounts()
    spill(project.page, "<p>")
    spill(project.results / "fig3/a b#.csv", "x\n")
    return project


def graph(project, now=NOW):
    """{id: entity}, none twice."""
    project.seal()
    whole = crate(project.root, now)
    found = {each["@id"]: each for each in whole["@graph"]}
    assert len(found) == len(whole["@graph"])
    assert f"{SPECIFICATION}/context" in whole["@context"]
    return found


@pytest.fixture(name="found", scope="module")
def graph_of_made_up_results(tmp_path_factory):
    return graph(make(tmp_path_factory.mktemp("crate")))


def references_in(thing):
    """All objects among an entity's values, which must be references."""
    if isinstance(thing, list):
        return [found for each in thing for found in references_in(each)]
    return [thing] if isinstance(thing, dict) else []


@pytest.mark.parametrize("name, has", SAYS)
def test_entities_say(found, name, has):
    assert {key: found[name][key] for key in has} == has


def test_it_is_flat_and_every_reference_leads_somewhere(found):
    for each in found.values():
        assert each["@type"]
        for reference in references_in(list(each.values())):
            assert list(reference) == ["@id"], each
            if each["@id"] != CRATE or reference["@id"] == "./":  # the specification is elsewhere
                assert reference["@id"] in found


def test_files_and_folders_exist_and_belong_to_the_root(project):
    found = graph(project)
    data = {name for name, each in found.items() if each["@type"] in ("File", "Dataset")}
    for name in data:
        assert re.fullmatch(r"\w[\w./%-]*|\./", name)
        assert (project.results / unquote(name)).exists(), name
        assert (found[name]["@type"] == "Dataset") == name.endswith("/")
    reached, waiting = {"./"}, ["./"]
    while waiting:
        parts = {each["@id"] for each in found[waiting.pop()].get("hasPart", [])} - reached
        reached |= parts
        waiting.extend(parts)
    assert reached == data
    assert str(project.root) not in json.dumps(found)


def test_checkpoints_and_recipes_without_files_are_left_out(project, capsys):
    spill(project.results / "sweeps/mine/mine.ini", "[commands]\n")
    project.seal()
    for name in ("mine", "theirs"):
        spill(project.results / f"sweeps/{name}/{name}.ini", "[commands]\na = b\n")
    runs = [one["@id"] for one in crate(project.root, NOW)["@graph"] if "#run-" in one["@id"]]
    assert len(runs) > 3 and not {"#run-fig5", "#run-sweeps/mine", "#run-sweeps/theirs"} & {*runs}
    assert "left out until ./reproduce.sh sweep mine.ini has made it" in capsys.readouterr().err
    (project.results / "store/ab/ab12.load.h5").unlink()
    assert not [name for name in graph(project) if name.startswith("store/")]


def test_equal_results_of_another_time_and_place_differ_in_dates_only(project, tmp_path):
    other = make(tmp_path / "with a space")
    for jobs in other.results.glob("*/jobs.jsonl"):
        jobs.write_text(jobs.read_text().replace('"started": 17', '"started": 18'))
    spill(other.page, "<p>later")
    first, later = graph(project), graph(other, NOW + 1e6)
    assert first != later
    for each in (*first.values(), *later.values()):
        for name in DATES:
            each.pop(name, None)
    assert first == later


# --- CITATION.cff ------------------------------------------------------------------------------


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_name_and_version_are_those_of_the_build():
    [found] = re.findall(r"^project\((\w+) VERSION (\S+)", text_of("CMakeLists.txt"), re.M)
    assert (CITED["title"].partition(":")[0], CITED["version"]) == found
    package = tomllib.loads(text_of("pyproject.toml"))["project"]
    assert (package["name"], package["version"]) == found


def test_licence_and_authors_are_those_of_the_licence():
    assert text_of("LICENSE").splitlines()[0] == f"{CITED['license']} License"
    holders = re.findall(r"^Copyright \(c\) \d+ (.*)$", text_of("LICENSE"), re.M)
    assert [person["name"] for person in CITED["authors"]] == holders


def test_the_readme_cites_the_paper():
    readme = " ".join(text_of("README.md").replace("> ", "").split())
    people = ", ".join(f"{who['given-names']} {who['family-names']}" for who in PAPER["authors"])
    for words in (people, PAPER["title"], PAPER["url"], str(PAPER["year"])):
        assert words in readme
