#!/usr/bin/env python3
"""The report of made-up results in a browser, after results/ was moved elsewhere: it loads
completely from the file system alone, and nothing bars readers from it in wide and narrow windows,
light and dark. The same checks must fail when something is wrong."""

import shutil
import tempfile
import unittest
from pathlib import Path

from fixture import Project, demand_browser, png, spill

BROWSER = demand_browser()
WAYS = [(width, scheme) for width in (1400, 400) for scheme in ("light", "dark")]
# What each must be noticed as.
PLANTED = {
    '<p style="color: #999">faint</p>': "contrast of",
    "<h5>deep</h5>": "heading skips a level",
    '<img src="claims.png">': "no alternative text",
    '<div style="width: 3000px">wide</div>': "the page scrolls sideways",
    '<ul><li style="width: 2em; overflow-wrap: normal">wideword</li></ul>': "over its edge",
    '<a href="#claims"></a>': "link without a name",
    "<table><tr><th>x</th></tr></table>": "no headers of columns",
    '<p style="overflow: auto; width: 5em; white-space: nowrap">a long line of words</p>': "no key",
    "<section>x</section>": "no label",
    '<p id="claims">x</p>': "an id twice",
}


class InBrowser(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(Path(folder.name) / "made")
        self.project.make_recipes()
        self.project.make_accounts()
        spill(self.project.root / "results/movie.gif", png(40, 30))  # browsers look at the content
        self.assertEqual(self.project.report().returncode, 0)
        self.results = Path(folder.name) / "moved"
        shutil.move(self.project.root / "results", self.results)
        self.page = self.results / "index.html"

    def plant(self, html):
        text = self.page.read_text(encoding="utf-8")
        self.page.write_text(text.replace("</main>", html + "</main>"), encoding="utf-8")

    def test_page_is_complete(self):
        seen = BROWSER.look(self.page)
        shown = {address for address, _ in seen.images}
        files = [*self.results.glob("**/*.png"), self.results / "movie.gif"]
        self.assertEqual(shown, {path.as_uri() for path in files})
        self.assertEqual(seen.missing_images(), [])
        self.assertEqual(seen.foreign_requests(), [])
        self.assertEqual(seen.errors, [])
        wanted = {f"claim-{listed.id}" for listed in self.project.judged()}
        self.assertEqual(wanted - set(seen.ids), set())

    def test_nothing_bars_readers(self):
        for width, scheme in WAYS:
            with self.subTest(width=width, scheme=scheme):
                self.assertEqual(BROWSER.look(self.page, width, scheme).faults, [])

    def test_a_dark_scheme_is_dark(self):
        ground = "return getComputedStyle(document.documentElement).backgroundColor"
        grounds = {}
        for scheme in ("light", "dark"):
            BROWSER.look(self.page, scheme=scheme)
            grounds[scheme] = BROWSER.driver.execute_script(ground)
        self.assertEqual(grounds["light"], "rgb(255, 255, 255)")
        self.assertNotEqual(grounds["dark"], grounds["light"])

    def test_what_bars_readers_is_noticed(self):
        clean = self.page.read_text(encoding="utf-8")
        for html, sentence in PLANTED.items():
            with self.subTest(sentence):
                self.plant(html)
                self.assertIn(sentence, "; ".join(BROWSER.look(self.page).faults))
                self.page.write_text(clean, encoding="utf-8")

    def test_a_missing_picture_is_noticed(self):
        (self.results / "fig3/fig3.png").unlink()
        seen = BROWSER.look(self.page)
        self.assertEqual({a.split("/")[-1] for a in seen.missing_images()}, {"fig3.png"})
        self.assertTrue(seen.errors)

    def test_a_foreign_request_is_noticed(self):
        self.plant(
            '<img alt="" src="https://example.org/a.png"><script>console.error("x")</script>'
        )
        seen = BROWSER.look(self.page)
        self.assertEqual(seen.foreign_requests(), ["https://example.org/a.png"])
        self.assertIn('"x"', "; ".join(seen.errors))
