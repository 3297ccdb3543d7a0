"""CITATION.cff says the same as CMakeLists.txt, LICENSE and the README."""

import re

import yaml

from conftest import ROOT


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


CITED = yaml.safe_load(text_of("CITATION.cff"))
[PAPER] = CITED["references"]


def test_it_has_what_the_format_requires():
    required = {"cff-version", "message", "title", "authors", "license", "abstract", "version"}
    assert required <= {key for key in CITED if CITED[key]}
    assert (CITED["cff-version"], CITED["type"]) == ("1.2.0", "software")


def test_name_and_version_are_those_of_the_build():
    [found] = re.findall(r"^project\((\w+) VERSION (\S+)", text_of("CMakeLists.txt"), re.M)
    assert (CITED["title"].partition(":")[0], CITED["version"]) == found


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
