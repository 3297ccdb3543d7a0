"""ro-crate-metadata.json from made-up results: what RO-Crate 1.1 demands, and what it says.
CITATION.cff, from which it is: that says the same as CMakeLists.txt, LICENSE and the README."""

import hashlib
import json
import re
import tomllib
from datetime import datetime
from urllib.parse import unquote

import h5py
import pytest
import yaml

from conftest import ROOT
from crate import CRATE, crate, write_crate
from fixture import START, Project, spill

NOW = 1.75e9  # [s] since 1970
CITED = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
[PAPER] = CITED["references"]
DATES = ("datePublished", "startTime", "endTime")


@pytest.fixture(name="project")
def made_up_project(tmp_path):
    return make(tmp_path / "one")


def make(root):
    project = Project(root)
    project.make_recipes()
    project.make_accounts()
    with h5py.File(project.results / "data/load.h5", "w") as file:
        for name, text in (("version", "0.9.0"), ("commit", "abc"), ("compiler", "gcc 12")):
            file[f"provenance/0/{name}"] = text
    spill(project.page, "<p>")
    return project


def graph(project, now=NOW):
    """{id: entity}, none twice."""
    entities = crate(project.root, now)["@graph"]
    found = {each["@id"]: each for each in entities}
    assert len(found) == len(entities)
    return found


def references_in(thing):
    """All objects among an entity's values, which must be references."""
    if isinstance(thing, list):
        return [found for each in thing for found in references_in(each)]
    return [thing] if isinstance(thing, dict) else []


def test_the_descriptor_and_the_root_are_as_specified(project):
    write_crate(project.root)
    written = json.loads((project.results / CRATE).read_text(encoding="utf-8"))
    assert "https://w3id.org/ro/crate/1.1/context" in written["@context"]
    found = graph(project)
    assert found["ro-crate-metadata.json"] == {
        "@id": "ro-crate-metadata.json",
        "@type": "CreativeWork",
        "conformsTo": {"@id": "https://w3id.org/ro/crate/1.1"},
        "about": {"@id": "./"},
    }
    top = found["./"]
    assert top["@type"] == "Dataset"
    assert min(len(top["name"]), len(top["description"])) > 20
    assert datetime.fromisoformat(top["datePublished"]).timestamp() == NOW
    assert found[top["license"]["@id"]]["name"] == "MIT License"


def test_it_is_flat_and_every_reference_leads_somewhere(project):
    found = graph(project)
    for each in found.values():
        assert each["@type"]
        for reference in references_in(list(each.values())):
            assert list(reference) == ["@id"], each
            if each["@id"] != CRATE or reference["@id"] == "./":  # the specification is elsewhere
                assert reference["@id"] in found


def test_files_and_folders_exist_and_belong_to_the_root(project):
    spill(project.results / "fig3/a b#.csv", "x\n")
    found = graph(project)
    assert found["fig3/a%20b%23.csv"]["name"] == "a b#.csv"
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


@pytest.mark.parametrize("name", ["fig3.png", "fig3.pdf", "claims.json", "front.csv"])
def test_figures_and_claims_have_checksums(project, name):
    content = (project.results / "fig3" / name).read_bytes()
    found = graph(project)[f"fig3/{name}"]
    assert found["sha256"] == hashlib.sha256(content).hexdigest()
    assert found["contentSize"] == str(len(content))


def test_checkpoints_have_the_checksums_of_their_content_while_they_exist(project):
    assert graph(project)["data/load.h5"]["identifier"] == "content-sha256:5eed5eed"
    (project.results / "data/load.h5").unlink()
    assert not [name for name in graph(project) if name.startswith("data/")]


def test_a_recipe_has_its_command_programs_inputs_results_and_times(project):
    found = graph(project)
    run = found["#run-fig3"]
    assert (run["@type"], run["name"]) == ("CreateAction", "./reproduce.sh fig3")
    assert "load -o fig3.h5 --until 1.2" in run["description"]
    assert run["object"] == [{"@id": "data/load.h5"}]
    assert {"@id": "fig3/fig3.png"} in run["result"]
    moments = [datetime.fromisoformat(run[name]).timestamp() for name in DATES[1:]]
    assert moments == [START, START + 61]
    source, programs = (found[each["@id"]] for each in run["instrument"])
    assert source["@type"] == "SoftwareSourceCode"
    assert (programs["@type"], programs["version"]) == ("SoftwareApplication", "0.9.0")
    assert "commit abc, gcc 12" in programs["description"]
    assert "#run-fig5" not in found  # it has no results


def test_the_paper_and_the_software_are_those_of_the_citation(project):
    found = graph(project)
    software = found["#rupture"]
    same = {
        "name": "title",
        "description": "abstract",
        "version": "version",
        "keywords": "keywords",
    }
    assert {key: software[key] for key in same} == {key: CITED[same[key]] for key in same}
    assert [found[one["@id"]]["name"] for one in software["author"]] == ["The rupture authors"]
    assert software["citation"] == found["./"]["citation"]
    paper = found[software["citation"]["@id"]]
    assert (paper["@type"], paper["name"]) == ("ScholarlyArticle", PAPER["title"])
    assert (paper["@id"], paper["datePublished"]) == (PAPER["url"], str(PAPER["year"]))
    assert found[paper["isPartOf"]["@id"]]["name"] == PAPER["journal"]
    for each, one in zip(paper["author"], PAPER["authors"], strict=True):
        person, given, family = found[each["@id"]], one["given-names"], one["family-names"]
        assert (person["givenName"], person["familyName"]) == (given, family)
        assert person["name"] == f"{given} {family}"


def test_equal_results_of_another_time_and_place_differ_in_dates_only(project, tmp_path):
    other = make(tmp_path / "with a space")
    jobs = other.results / "jobs.jsonl"
    jobs.write_text(jobs.read_text().replace('"started": 17', '"started": 18'))
    (other.results / "data/load.h5").write_bytes((project.results / "data/load.h5").read_bytes())
    spill(other.page, "<p>later")
    first, later = graph(project), graph(other, NOW + 1e6)
    assert first != later
    for each in (*first.values(), *later.values()):
        for name in DATES:
            each.pop(name, None)
    assert first == later


def test_a_crate_without_results_is_still_one(tmp_path):
    found = graph(Project(tmp_path))
    assert list(found)[:2] == [CRATE, "./"]
    assert not [each for each in found.values() if each["@type"] == "File"]


# --- CITATION.cff ------------------------------------------------------------------------------


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_it_has_what_the_format_requires():
    required = {"cff-version", "message", "title", "authors", "license", "abstract", "version"}
    assert required <= {key for key in CITED if CITED[key]}
    assert (CITED["cff-version"], CITED["type"]) == ("1.2.0", "software")


def test_name_and_version_are_those_of_the_build():
    [found] = re.findall(r"^project\((\w+) VERSION (\S+)", text_of("CMakeLists.txt"), re.M)
    assert (CITED["title"].partition(":")[0], CITED["version"]) == found
    package = tomllib.loads(text_of("pyproject.toml"))["project"]
    assert (package["name"], package["version"]) == found


def test_licence_and_authors_are_those_of_the_licence():
    assert text_of("LICENSE").splitlines()[0] == f"{CITED['license']} License"
    holders = re.findall(r"^Copyright \(c\) \d+ (.*)$", text_of("LICENSE"), re.M)
    assert [person["name"] for person in CITED["authors"]] == holders


def test_no_identifier_is_made_up():
    """Nobody has given the programs a DOI or an address yet."""
    assert not CITED.keys() & {"doi", "url", "identifier", "identifiers", "repository-code"}
    [preprint] = [one["value"] for one in PAPER["identifiers"]]
    assert PAPER["url"].endswith(preprint.removeprefix("arXiv:"))


def test_the_readme_cites_the_paper():
    readme = " ".join(text_of("README.md").replace("> ", "").split())
    people = ", ".join(f"{who['given-names']} {who['family-names']}" for who in PAPER["authors"])
    for words in (people, PAPER["title"], PAPER["url"], str(PAPER["year"])):
        assert words in readme
