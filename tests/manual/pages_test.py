"""The man pages: there is one per tool, man and lexgrog find no fault, all options are in them."""

import json
import os
import subprocess
import unittest

from conftest import BUILD, need

need("lexgrog")
PAGES = BUILD / "manual/man"
PLAIN = os.environ | {
    "LC_ALL": "C.UTF-8",
    "MANWIDTH": "80",
    "MANROFFSEQ": "",
    "MAN_KEEP_FORMATTING": "",
}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True, env=PLAIN)


def text_of(page):
    return run("man", "--no-hyphenation", "--no-justification", "-l", page).stdout


DESCRIPTION = json.loads(run(BUILD / "bin/rupture", "--describe").stdout)
TOOLS = DESCRIPTION["tools"]


class Pages(unittest.TestCase):
    def test_there_is_one_for_each_tool_and_one_for_rupture(self):
        names = {f"rupture-{tool['name']}.1.gz" for tool in TOOLS} | {"rupture.1.gz"}
        self.assertEqual({page.name for page in PAGES.iterdir()}, names)

    def test_man_finds_no_fault(self):
        for page in PAGES.iterdir():
            strict = run("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page)
            self.assertEqual(strict.stderr, "", page.name)

    def test_lexgrog_finds_name_and_summary(self):
        for tool in TOOLS:
            page = PAGES / f"rupture-{tool['name']}.1.gz"
            expected = f'{page}: "rupture-{tool["name"]} - {tool["summary"]}"\n'
            self.assertEqual(run("lexgrog", page).stdout, expected)

    def test_all_options_and_commands_are_explained(self):
        for tool in TOOLS:
            text = " ".join(text_of(PAGES / f"rupture-{tool['name']}.1.gz").split())
            self.assertIn(f"SYNOPSIS rupture {tool['synopsis']} DESCRIPTION", text)
            self.assertNotRegex(text, r"\[(.+)\] \[\1\]", "a unit stands twice")
            for command in tool.get("commands", []):
                self.assertIn(command["synopsis"].removeprefix(tool["name"] + " "), text)
            for leaf in tool.get("commands") or [tool]:
                self.assertIn(" ".join(leaf["purpose"].split()), text)
                for option in leaf["options"]:
                    self.assertIn(f"--{option['name']}", text)
                    if leaf is tool:
                        self.assertIn(" ".join(option["help"].split()), text)

    def test_parameters_have_a_page(self):
        text = " ".join(text_of(PAGES / "rupture-parameters.1.gz").split())
        self.assertIn(
            "junctions.t_R [s] mean slipping time (above 0, at most 1000; default: 0.002; laws:"
            " reference, simplified, decaying)",
            text,
        )
