#!/usr/bin/env python3
"""Tests of the report's page, made of made-up results; no browser is needed."""

import json
import re
import shutil
import tempfile
import unittest

from fixture import NOT_RUN, POINTS, SOURCE, START, Project, listed_claims, spill
from links import Links

SHIPPED = sorted(path.parent.name for path in (SOURCE / "recipes").glob("*/rules.smk"))


class Page(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        self.project.make_recipes()

    def page(self):
        done = self.project.report()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"Report: {self.project.page}\n")
        return self.project.page.read_text(encoding="utf-8")

    def test_files_of_others_are_not_replaced(self):
        for name in ("index.html", "ro-crate-metadata.json", "claims.png"):
            path = (self.project.root / "results" / name).resolve()
            path.symlink_to("mine")
            done = self.project.report()
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(f"report.py: {path} was not written by", done.stderr)
            self.assertEqual(path.readlink().name, "mine")
            path.unlink()
        self.project.page.write_text("mine")
        self.assertEqual(self.project.report().returncode, 1)
        self.assertEqual(self.project.page.read_text(), "mine")
        self.project.page.unlink()
        self.page()
        self.page()

    def section(self, name):
        return re.findall(rf'<section id="{name}".*?</section>', self.page(), re.S)[0]

    def refusal(self):
        """The sentence with which report.py fails; it writes no page then."""
        done = self.project.report()
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse(self.project.page.exists())
        return done.stderr

    def test_lists_every_judged_claim_in_order(self):
        ids = [i[6:] for i in re.findall(r'<tr id="(claim-[^"]+)"', self.page())]
        self.assertEqual(ids, [listed.id for listed in self.project.judged()])

    def test_counts_verdicts(self):
        counts = re.findall(r"<strong>(\d+)</strong>", self.page())
        expected = [len(self.project.judged()) - 1, 0, 1, 0]
        self.assertEqual([int(count) for count in counts], expected)

    def test_says_nothing_of_what_was_not_run(self):
        page = self.page()
        for name in ("fig5", "fig10", *NOT_RUN):
            self.assertNotRegex(page, rf"\b{name}\b")
        self.assertNotIn("Figure 5", page)
        total = len(self.project.listed)
        self.assertIn(f"{total - len(NOT_RUN)} of the paper's {total} claims", page)

    def test_gallery_has_a_picture_and_verdicts_of_each_recipe(self):
        gallery = self.section("gallery")
        cards = re.findall(r'<a class="card" href="#(\w+)">\s*<img src="([^"]+)"', gallery)
        names = re.findall(r'<section id="((?:fig|est|rob)\w*)"', self.page())
        self.assertEqual(cards, [(name, f"{name}/{name}.png") for name in names])
        chips = re.findall(r'href="#result-(\w+)"\s+aria-label="([^"]+)"', gallery)
        self.assertIn(("S1", "S1: differs"), chips)
        self.assertEqual({claim for claim, _ in chips}, {c.id for c in self.project.judged()})

    def test_the_movie_comes_first_if_there_is_one(self):
        self.assertNotIn("<video", self.page())
        self.assertNotIn("movie", self.page().partition("</style>")[2])
        spill(self.project.root / "results/movie.gif", "GIF")
        self.assertIn('<img src="movie.gif"', self.page().partition('id="gallery"')[0])
        spill(self.project.root / "results/movie.mp4", "MP4")
        page = self.page()
        self.assertIn(
            '<source src="movie.mp4" type="video/mp4">', page.partition('id="gallery"')[0]
        )
        self.assertNotIn('<img src="movie.gif"', page)
        self.assertNotIn("poster", page)
        spill(self.project.root / "results/movie.png", "PNG")
        self.assertIn('poster="movie.png"', self.page())

    def test_orders_recipes_as_the_paper_does(self):
        names = re.findall(r'<section id="([^"]+)"', self.page())
        figures = [f"fig{n}" for n in range(1, 5)] + [f"figS{n}" for n in range(1, 7)]
        others = ["estimate", "robustness", "claims", "verdicts", "build"]
        self.assertEqual(names, ["gallery", *figures, *others])

    def test_shows_pictures_and_data(self):
        section = self.section("fig3")
        for name in ("fig3.png", "fig3.pdf", "front.csv", "claims.json"):
            self.assertIn(f'href="fig3/{name}"', section)
        self.assertIn('src="fig3/fig3.png"', section)
        self.assertIn('alt="Title of fig3 &amp; more. A: it is slow. B: the README."', section)

    def test_shows_caption_and_commands(self):
        section = self.section("fig3")
        mean = "<mo>⟨</mo><msub><mi>t</mi><mi>R</mi></msub><mo>⟩</mo>"
        self.assertIn(f"<em>slow</em> part takes <math>{mean}</math>", section)
        self.assertIn(
            "<li><strong>A</strong>: it is slow; <code>front.csv</code>: how slow.</li>", section
        )
        self.assertIn('<a href="#figS3">another</a>; the README', section)
        self.assertIn("load -o fig3.h5 --until 1.2\nanalyze front fig3.h5</code>", section)
        self.assertNotIn("What is done", section)

    def test_fills_numbers_into_captions(self):
        readme = self.project.root / "recipes/fig2/README.md"
        text = (
            "At {2A: speed [m/s]}, {2B:\nlist [mm]}; {2A: no such [s]}, {5A: speed [m/s]};"
            " {} {x: y} {2A}."
        )
        spill(readme, f"# Title\n\n## Caption\n\n{text}\n")
        self.assertIn(
            "At 12.35\u00a0m/s, 1, none\u00a0mm; not run, not run; {} not run {2A}.",
            self.section("fig2"),
        )

    def test_captions_leave_out_sentences_without_any_number(self):
        readme = self.project.root / "recipes/fig2/README.md"
        items = "- one;\n- {5A: speed [m/s]} of {5A: all};\n- two."
        text = f"First. It runs at {{5A: speed\n[m/s]}} in Fig. {{5B: list [mm]}}. Last.\n\n{items}"
        spill(readme, f"# Title\n\n## Caption\n\n{text}\n")
        section = self.section("fig2")
        self.assertIn("<p>First. Last.</p>", " ".join(section.split()))
        self.assertEqual(re.findall(r"<li>\s*(?:<p>)?(\w+)", section)[:2], ["one", "two"])

    def test_captions_name_claims_and_own_results_of_their_recipe(self):
        for listed in SHIPPED:
            recipe = SOURCE / "recipes" / listed
            caption = (recipe / "README.md").read_text(encoding="utf-8").partition("## Caption")[2]
            named = set(re.findall(r"\{(\w+):", caption))
            ids = {claim.id for claim in listed_claims(SOURCE) if claim.recipe == listed}
            scripts = "".join(path.read_text(encoding="utf-8") for path in recipe.glob("*.py"))
            own = set(re.findall(r'OwnResult\(\s*(?:id=)?"(\w+)"', scripts))
            self.assertLessEqual(named, ids | own, listed)

    def test_escapes_everything(self):
        page = self.page()
        self.assertIn("&lt;script&gt;twice&lt;/script&gt;", page)
        self.assertNotIn("<script", page)
        self.assertNotIn("<b>", page)

    def test_shows_measured_values(self):
        section = self.section("fig2")
        self.assertIn("<li>speed = 12.35 m/s</li>", section)
        self.assertIn("<li>list = 1, none mm</li>", section)

    def test_shows_shares_and_reasons(self):
        row = re.findall(r'<tbody id="result-2A".*?</tbody>', self.page(), re.S)[0]
        text = " ".join(row.split())
        self.assertIn("primary: 7 of 20 (0.20 to 0.53)", text)
        self.assertIn("holds as it should", text)

    def test_the_picture_of_all_claims_is_drawn_when_that_changes_it(self):
        picture = self.project.root / "results/claims.png"
        claims = self.project.root / "results/fig2/claims.json"
        self.page()
        drawn = picture.stat().st_mtime_ns
        self.page()
        self.assertEqual(picture.stat().st_mtime_ns, drawn)
        claims.write_text(claims.read_text().replace('"shown": true', '"shown": false'))
        self.page()
        self.assertGreater(picture.stat().st_mtime_ns, drawn)
        picture.with_suffix(".pdf").unlink()
        self.page()
        self.assertTrue(picture.with_suffix(".pdf").exists())

    def test_adds_up_times_counting_a_job_once(self):
        self.project.make_accounts()
        self.assertIn("What the pipeline ran: 2 jobs, 51 s", self.section("fig2"))
        self.assertIn("What the pipeline ran: 2 jobs, 51 s", self.section("fig3"))
        self.assertIn(f"{POINTS + 4} jobs, 10 min 54 s", self.section("build"))

    def test_shows_the_last_run_that_computed_anything(self):
        self.project.make_accounts()
        run = {
            "recipes": "fig2 fig3",
            "where": "with 2 cores",
            "started": int(START),
            "seconds": 65,
        }
        idle = {
            "recipes": "fig3",
            "where": "with 1 cores",
            "started": int(START) + 1000,
            "seconds": 4,
        }
        spill(self.project.root / "results/runs.jsonl", f"{json.dumps(run)}\n{json.dumps(idle)}\n")
        text = " ".join(self.section("build").split())
        self.assertIn("fig2 fig3 with 2 cores, 3 jobs in 65 s from start to end", text)

    def test_shows_commands_but_not_each_of_many(self):
        self.project.make_accounts()
        section = self.section("fig4")
        self.assertIn(f"point: {POINTS} jobs, 10 min 0 s", section)
        self.assertEqual(section.count("tool --rule point"), 1)
        self.assertIn("echo &lt;results/fig4/claims.json&gt;", section)

    def test_shows_checksums(self):
        self.project.make_accounts()
        section = self.section("fig2")
        self.assertIn("load.h5</code>", section)
        self.assertIn("5eed5eed", section)
        self.assertNotIn("5eed5eed", self.section("fig4"))

    def test_results_may_be_copied_alone(self):
        self.project.make_accounts()
        self.page()
        results = self.project.root / "copied"
        shutil.move(self.project.root / "results", results)
        links = Links(results / "index.html")
        self.assertEqual(links.broken(), [])
        self.assertEqual(links.outside(), [])
        self.assertEqual(links.foreign_sources(), [])
        self.assertEqual(len(links.ids), len(set(links.ids)))

    def test_refuses_broken_claims(self):
        path = self.project.root / "results/fig3/claims.json"
        for text in ("[{", '[{"id": "3A"}]', "7", "[1]", '{"id": "3A"}'):
            with self.subTest(text):
                spill(path, text)
                self.assertIn("claims.json holds no table of claims (", self.refusal())

    def test_refuses_unlisted_and_doubled_claims(self):
        path = self.project.root / "results/fig3/claims.json"
        claims = json.loads(path.read_text())
        spill(path, json.dumps([claims[0], claims[0]]))
        self.assertIn("Claim '3A' is in", self.refusal())
        spill(path, json.dumps([claims[0] | {"id": "3Z"}]))
        self.assertIn("a claim '3Z' that claims.toml does not list", self.refusal())

    def test_refuses_a_broken_picture(self):
        spill(self.project.root / "results/fig3/fig3.png", "no picture")
        self.assertIn("fig3.png is no PNG", self.refusal())


class EmptyProject(unittest.TestCase):
    def test_says_what_to_run(self):
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            self.assertEqual(project.report().returncode, 0)
            page = project.page.read_text(encoding="utf-8")
        self.assertIn("./reproduce.sh all", page)
        self.assertNotIn('<section id="gallery"', page)


if __name__ == "__main__":
    unittest.main()
