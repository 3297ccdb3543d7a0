#!/usr/bin/env python3
"""results/index.html as it is in this folder, if ./reproduce.sh report has written it."""

import json
import unittest

import pytest

from fixture import SOURCE, demand_browser
from links import Links

PAGE = SOURCE / "results/index.html"
if not PAGE.exists():
    pytest.skip("./reproduce.sh report has written no results/index.html", allow_module_level=True)
BROWSER = demand_browser()

# Results may have changed since the page was written.
OUTDATED = "./reproduce.sh report writes the page anew"


class RealPage(unittest.TestCase):
    def test_has_every_claim_and_no_broken_link(self):
        links = Links(PAGE)
        self.assertEqual(links.broken(), [], OUTDATED)
        self.assertEqual(links.outside(), [])
        self.assertEqual(links.foreign_sources(), [])
        tables = [json.loads(path.read_text()) for path in PAGE.parent.glob("*/claims.json")]
        wanted = {f"claim-{claim['id']}" for table in tables for claim in table}
        self.assertEqual(wanted - set(links.ids), set(), OUTDATED)

    def test_loads_completely_from_the_file_system(self):
        seen = BROWSER.look(PAGE)
        self.assertEqual(seen.missing_images(), [], OUTDATED)
        self.assertEqual(seen.foreign_requests(), [])
        self.assertEqual(seen.errors, [])

    def test_nothing_bars_readers(self):
        for width in (1400, 400):
            for scheme in ("light", "dark"):
                with self.subTest(width=width, scheme=scheme):
                    self.assertEqual(BROWSER.look(PAGE, width, scheme).faults, [])
