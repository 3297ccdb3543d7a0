#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The report of made-up results in a browser: it loads completely, and from the file system alone.
The same check must fail when a picture is gone or something foreign is asked for."""

import tempfile
import unittest

from browser import look
from fixture import Project, demand_chromium


class InBrowser(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.project.make_recipes()
        self.project.make_accounts()
        self.assertEqual(self.project.report().returncode, 0)

    def look(self):
        return look(CHROMIUM, self.project.page)

    def test_page_is_complete(self):
        seen = self.look()
        self.assertEqual(len(seen.images), len(list(self.project.root.glob("results/**/*.png"))))
        self.assertEqual(seen.missing_images(), [])
        self.assertEqual(seen.foreign_requests(), [])
        self.assertEqual(seen.errors, [])
        wanted = {f"claim-{listed.id}" for listed in self.project.listed}
        self.assertEqual(wanted - set(seen.ids), set())
        self.assertIn("not run", seen.text)

    def test_a_missing_picture_is_noticed(self):
        (self.project.root / "results/fig3/fig3.png").unlink()
        seen = self.look()
        self.assertEqual([a.split("/")[-1] for a in seen.missing_images()], ["fig3.png"])
        self.assertEqual(len(seen.errors), 1)

    def test_a_foreign_request_is_noticed(self):
        text = self.project.page.read_text(encoding="utf-8")
        image = '<img alt="" src="https://example.org/a.png"><script>console.error("x")</script>'
        self.project.page.write_text(text.replace("<main>", "<main>" + image), encoding="utf-8")
        seen = self.look()
        self.assertEqual(seen.foreign_requests(), ["https://example.org/a.png"])
        self.assertIn("x", seen.errors)


if __name__ == "__main__":
    CHROMIUM = demand_chromium()
    unittest.main()
