#!/usr/bin/env python3
"""ro-crate-metadata.json from made-up results: what RO-Crate 1.1 demands, and what is told."""

import hashlib
import json
import re
import sys
import tempfile
import unittest
from datetime import datetime
from pathlib import Path
from urllib.parse import unquote

import h5py

from fixture import SOURCE, START, Project, spill

sys.path.insert(0, str(SOURCE / "recipes/common"))
from crate import CRATE, crate, write_crate  # noqa: E402  (found through the line above)

NOW = 1.75e9  # [s] since 1970
LOAD = "data/load.h5"

DATES = ("datePublished", "startTime", "endTime")


def references_in(thing):
    """All objects among an entity's values, which must be references."""
    if isinstance(thing, list):
        return [found for each in thing for found in references_in(each)]
    return [thing] if isinstance(thing, dict) else []


def without_dates(graph):
    return [{key: each[key] for key in each if key not in DATES} for each in graph]


class Crate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.root = self.project.root
        self.results = self.root / "results"
        self.project.make_recipes()
        self.project.make_accounts()
        self.write_load("0.9.0")
        spill(self.project.page, "<p>")

    def write_load(self, version):
        with h5py.File(self.results / LOAD, "w") as file:
            for name, text in (("version", version), ("commit", "abc"), ("compiler", "gcc 12")):
                file[f"provenance/0/{name}"] = text

    def graph(self, now=NOW):
        return crate(self.root, now)["@graph"]

    def entity(self, identity):
        [found] = [each for each in self.graph() if each["@id"] == identity]
        return found

    def test_the_descriptor_and_the_root_are_as_specified(self):
        write_crate(self.root)
        text = (self.results / CRATE).read_text(encoding="utf-8")
        self.assertIn("https://w3id.org/ro/crate/1.1/context", json.loads(text)["@context"])
        descriptor = self.entity("ro-crate-metadata.json")
        self.assertEqual(descriptor["@type"], "CreativeWork")
        self.assertEqual(descriptor["conformsTo"], {"@id": "https://w3id.org/ro/crate/1.1"})
        self.assertEqual(descriptor["about"], {"@id": "./"})
        top = self.entity("./")
        self.assertEqual(top["@type"], "Dataset")
        for name in ("name", "description"):
            self.assertGreater(len(top[name]), 20)
        self.assertEqual(datetime.fromisoformat(top["datePublished"]).timestamp(), NOW)
        self.assertIn("name", self.entity(top["license"]["@id"]))

    def test_it_is_flat_and_every_reference_leads_somewhere(self):
        graph = self.graph()
        known = [each["@id"] for each in graph]
        self.assertEqual(len(known), len(set(known)))
        for each in graph:
            self.assertTrue(each["@type"])
            for found in references_in(list(each.values())):
                self.assertEqual(list(found), ["@id"], each)
                if each["@id"] != CRATE or found["@id"] == "./":  # the specification is elsewhere
                    self.assertIn(found["@id"], known)

    def test_files_and_folders_exist_and_belong_to_the_root(self):
        graph = {each["@id"]: each for each in self.graph()}
        data = {name for name, each in graph.items() if each["@type"] in ("File", "Dataset")}
        for name in data:
            self.assertRegex(name, r"^[\w./%-]+$")
            self.assertTrue((self.results / unquote(name)).exists(), name)
            self.assertEqual(graph[name]["@type"] == "Dataset", name.endswith("/"))
        reached, waiting = {"./"}, ["./"]
        while waiting:
            parts = {each["@id"] for each in graph[waiting.pop()].get("hasPart", [])} - reached
            reached |= parts
            waiting.extend(parts)
        self.assertEqual(reached, data)

    def test_figures_and_claims_have_checksums(self):
        for name in ("fig3/fig3.png", "fig3/fig3.pdf", "fig3/claims.json", "fig3/front.csv"):
            content = (self.results / name).read_bytes()
            found = self.entity(name)
            self.assertEqual(found["sha256"], hashlib.sha256(content).hexdigest())
            self.assertEqual(found["contentSize"], str(len(content)))

    def test_checkpoints_have_the_checksums_of_their_content(self):
        self.assertEqual(self.entity(LOAD)["identifier"], "content-sha256:5eed5eed")

    def test_a_checkpoint_that_is_gone_is_left_out(self):
        (self.results / LOAD).unlink()
        self.assertFalse([each for each in self.graph() if each["@id"].startswith("data/")])

    def test_a_recipe_has_its_command_programs_inputs_results_and_times(self):
        run = self.entity("#run-fig3")
        self.assertEqual((run["@type"], run["name"]), ("CreateAction", "./reproduce.sh fig3"))
        self.assertIn("load -o fig3.h5 --until 1.2", run["description"])
        self.assertEqual(run["object"], [{"@id": LOAD}])
        self.assertIn({"@id": "fig3/fig3.png"}, run["result"])
        moments = [datetime.fromisoformat(run[name]).timestamp() for name in DATES[1:]]
        self.assertEqual(moments, [START, START + 61])
        source, programs = (self.entity(each["@id"]) for each in run["instrument"])
        self.assertEqual(source["@type"], "SoftwareSourceCode")
        self.assertEqual((programs["@type"], programs["version"]), ("SoftwareApplication", "0.9.0"))
        self.assertIn("commit abc, gcc 12", programs["description"])

    def test_a_recipe_without_results_has_no_action(self):
        self.assertFalse([each for each in self.graph() if each["@id"] == "#run-fig5"])

    def test_the_paper_and_the_software_are_those_of_codemeta(self):
        codemeta = json.loads((SOURCE / "codemeta.json").read_text(encoding="utf-8"))
        software = self.entity("#rupture")
        self.assertEqual(software["version"], codemeta["version"])
        self.assertEqual(software["citation"], self.entity("./")["citation"])
        paper = self.entity(software["citation"]["@id"])
        people = [self.entity(each["@id"])["name"] for each in paper["author"]]
        self.assertEqual((paper["@type"], people[0]), ("ScholarlyArticle", "J. K. Trømborg"))

    def test_equal_results_of_another_time_and_place_differ_in_dates_only(self):
        with tempfile.TemporaryDirectory() as folder:
            other = Project(Path(folder) / "with a space")
            other.make_recipes()
            other.make_accounts()
            jobs = other.root / "results/jobs.jsonl"
            spill(jobs, re.sub(r'"started": 17', '"started": 18', jobs.read_text()))
            spill(other.root / "results" / LOAD, (self.results / LOAD).read_bytes())
            spill(other.page, "<p>later")
            later = crate(other.root, NOW + 1e6)["@graph"]
        first = self.graph()
        self.assertNotEqual(first, later)
        self.assertEqual(without_dates(first), without_dates(later))

    def test_no_path_leads_out_of_the_folder(self):
        self.assertNotIn(str(self.root), json.dumps(self.graph()))
        self.assertFalse([each for each in self.graph() if each["@id"].startswith(("/", ".."))])

    def test_names_are_escaped_as_addresses(self):
        spill(self.results / "fig3/a b#.csv", "x\n")
        self.assertEqual(self.entity("fig3/a%20b%23.csv")["name"], "a b#.csv")


class EmptyProject(unittest.TestCase):
    def test_a_crate_without_results_is_still_one(self):
        with tempfile.TemporaryDirectory() as folder:
            graph = crate(Project(folder).root, NOW)["@graph"]
        self.assertEqual([each["@id"] for each in graph[:2]], [CRATE, "./"])
        self.assertEqual([each for each in graph if each["@type"] == "File"], [])


if __name__ == "__main__":
    unittest.main()
