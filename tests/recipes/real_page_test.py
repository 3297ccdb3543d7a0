#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""results/index.html as it is in this folder, if ./reproduce.sh report has written it."""

import unittest

from browser import look
from fixture import SOURCE, demand_chromium, listed_claims, skip
from links import Links

PAGE = SOURCE / "results/index.html"


# Results may have changed since the page was written.
OUTDATED = "./reproduce.sh report writes the page anew"


class RealPage(unittest.TestCase):
    def test_has_every_claim_and_no_broken_link(self):
        links = Links(PAGE)
        self.assertEqual(links.broken(), [], OUTDATED)
        self.assertEqual(links.foreign_sources(), [])
        wanted = {f"claim-{listed.id}" for listed in listed_claims(SOURCE)}
        self.assertEqual(wanted - set(links.ids), set(), OUTDATED)

    def test_loads_completely_from_the_file_system(self):
        seen = look(CHROMIUM, PAGE)
        self.assertEqual(seen.missing_images(), [], OUTDATED)
        self.assertEqual(seen.foreign_requests(), [])
        self.assertEqual(seen.errors, [])


if __name__ == "__main__":
    if not PAGE.exists():
        skip("there is no results/index.html; ./reproduce.sh report writes it.")
    CHROMIUM = demand_chromium()
    unittest.main()
