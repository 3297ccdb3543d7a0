#!/usr/bin/env python3
"""CITATION.cff, codemeta.json and .zenodo.json say the same as CMakeLists.txt and LICENSE."""

import json
import re
import unittest

import yaml

from fixture import SOURCE


def text_of(name):
    return (SOURCE / name).read_text(encoding="utf-8")


CFF = yaml.safe_load(text_of("CITATION.cff"))
CODEMETA = json.loads(text_of("codemeta.json"))
ZENODO = json.loads(text_of(".zenodo.json"))
[(PROJECT, VERSION)] = re.findall(r"^project\((\w+) VERSION (\S+)", text_of("CMakeLists.txt"), re.M)
NO_IDENTIFIERS = "nobody has given the programs a DOI or an address yet"


def names(people):
    return [person["name"] for person in people]


class Software(unittest.TestCase):
    def test_each_format_has_what_it_requires(self):
        for found, required in (
            (CFF, "cff-version message title authors"),
            (CODEMETA, "@context @type name version license author description"),
            (ZENODO, "title upload_type description creators access_right license version"),
        ):
            self.assertLessEqual(set(required.split()), {key for key in found if found[key]})
        self.assertEqual((CFF["cff-version"], CFF["type"]), ("1.2.0", "software"))
        self.assertEqual(CODEMETA["@context"], "https://w3id.org/codemeta/3.0")
        self.assertEqual(CODEMETA["@type"], "SoftwareSourceCode")
        self.assertEqual((ZENODO["upload_type"], ZENODO["access_right"]), ("software", "open"))

    def test_the_version_is_that_of_the_build(self):
        versions = [found["version"] for found in (CFF, CODEMETA, ZENODO)]
        self.assertEqual(versions, 3 * [VERSION])

    def test_the_title_begins_with_the_projects_name(self):
        titles = {CFF["title"], CODEMETA["name"], ZENODO["title"]}
        self.assertEqual([title.partition(":")[0] for title in titles], [PROJECT])

    def test_the_licence_is_that_of_the_file(self):
        self.assertEqual(text_of("LICENSE").splitlines()[0], "MIT License")
        self.assertEqual((CFF["license"], ZENODO["license"]), ("MIT", "MIT"))
        self.assertEqual(CODEMETA["license"], "https://spdx.org/licenses/MIT")

    def test_the_authors_are_those_of_the_licence(self):
        holders = re.findall(r"^Copyright \(c\) \d+ (.*)$", text_of("LICENSE"), re.M)
        for people in (CFF["authors"], CODEMETA["author"], ZENODO["creators"]):
            self.assertEqual(names(people), holders)

    def test_descriptions_and_keywords_are_the_same(self):
        for found in (CODEMETA, ZENODO):
            self.assertEqual(found["description"], CFF["abstract"])
            self.assertEqual(found["keywords"], CFF["keywords"])

    def test_no_identifier_is_made_up(self):
        for found in (CFF, CODEMETA, ZENODO):
            for key in ("doi", "url", "identifier", "identifiers", "repository-code"):
                self.assertNotIn(key, found, NO_IDENTIFIERS)


class Paper(unittest.TestCase):
    def test_it_is_the_same_everywhere(self):
        [paper] = CFF["references"]
        same = CODEMETA["referencePublication"]
        self.assertEqual((same["@id"], same["name"]), (paper["url"], paper["title"]))
        self.assertEqual(same["isPartOf"]["name"], paper["journal"])
        self.assertEqual(same["datePublished"], str(paper["year"]))
        self.assertEqual(
            [(person["familyName"], person["givenName"]) for person in same["author"]],
            [(person["family-names"], person["given-names"]) for person in paper["authors"]],
        )
        [preprint] = [related["identifier"] for related in ZENODO["related_identifiers"]]
        self.assertEqual(paper["identifiers"][0]["value"], preprint)
        self.assertTrue(paper["url"].endswith(preprint.removeprefix("arXiv:")))

    def test_the_readme_cites_it(self):
        [paper] = CFF["references"]
        readme = " ".join(text_of("README.md").replace("> ", "").split())
        people = ", ".join(
            f"{who['given-names']} {who['family-names']}" for who in paper["authors"]
        )
        for words in (people, paper["title"], paper["url"], str(paper["year"])):
            self.assertIn(words, readme)


if __name__ == "__main__":
    unittest.main()
