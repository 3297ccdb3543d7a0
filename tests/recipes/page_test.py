"""The report's page of made-up results (fixture.py), and what it makes of captions and symbols."""

import ast
import inspect
import json
import re
import types
from functools import cache
from pathlib import Path
from unittest.mock import patch

import pytest

from report import readme
from report import page as report
from report.caption import PLACE, as_html, filled, seen
from report.symbols import typeset
from claims.claim import Claim
from rupture.errors import Failure
from claims.recipes import function_of, paper_of, recipe_names
from claims.table import table
from conftest import ROOT
from fixture import JUDGED, NOT_RUN, Project, result, results_of, spill

FIGURES = [*(f"fig{n}" for n in range(1, 5)), *(f"figS{n}" for n in range(1, 7))]
RECIPES = [*FIGURES, *sorted({table()[claim]["recipe"] for claim in JUDGED} - {*FIGURES})]
ITEM = "<li><strong>A</strong>: it is slow; <code>front.csv</code>: how slow.</li>"
# What sections say: their name, and the text, which may go over several lines.
SAYS = [
    ("gallery", '<a class="verdict differs" href="#result-S1" aria-label="S1: differs"'),
    ("fig3", 'href="fig3/fig3.pdf"'),
    ("fig3", 'href="fig3/claims.json"'),
    ("fig3", 'alt="Title of fig3 &amp; &lt;more&gt;. The slow part takes ⟨t_R⟩."'),
    ("fig3", "<em>slow</em> part takes ⟨t<sub>R</sub>⟩"),
    ("fig3", ITEM),
    ("fig3", '<a href="#figS3">another</a>; the README'),
    ("fig3", "load -o fig3.h5 --until 1.2 analyze front fig3.h5</code>"),
    ("fig2", "Measured &lt;script&gt;twice&lt;/script&gt;."),
    ("fig2", '<th scope="row">speed [m/s]</th><td><span>12.3</span></td></tr>'),
    ("fig2", '<th scope="row">list [mm]</th><td><span>1</span><span>none</span></td></tr>'),
    ("numbers", '<td data-label="median">8.4 (8 to 9) of 9 fronts</td>'),
    ("fig2", "primary: 7 of 20 (0.20 to 0.53)"),
    ("fig3", 'href="fig3/jobs.jsonl"'),
    ("build", "rupture 0.9.0, commit abc: 1 command<"),
    ("fig2", 'our own, without verdict: how near?</summary> <table class="numbers">'),
    ("fig2", '<th scope="row">off by [mm]</th><td><span>1.5</span></td></tr>'),
    ("fig2", "(expected: at most 1)</th><td><span>1.5</span></td>"),
]
OWN = {"id": "near", "question": "how near?", "measured": {"off by [mm]": 1.5, "a": None}}
EXPECTED = OWN | {"expected": {"off by [mm]": {"at_most": 1}}, "met": False}
CAPTIONS = [  # a caption, and what becomes of it
    (
        "At {2A: speed [m/s]}, {2B:\nlist [mm]}; {own: no such [s]},"
        " {5A: speed [m/s]}; {} {x: y} {2A}.",
        "At 12.3 m/s, 1, none mm; not run, not run; {} not run {2A}.",
    ),
    ("First. It runs at {5A: speed\n[m/s]} in Fig. {5B: list [mm]}. Last.", "<p>First. Last.</p>"),
    (
        "- one;\n- {5A: speed [m/s]} of {5A: all};\n- two.",
        "<li> <p>one;</p> </li> <li> <p>two.</p> </li>",
    ),
]
TYPESET = {
    "at v_slow slip": "at v<sub>slow slip</sub>",
    "tau_bar_0": "τ̄<sub>0</sub>",
    "<c_s>, R^2 +- 3e-12": "⟨c<sub>s</sub>⟩, R<sup>2</sup> ± 3e-12",
    "57 x 31 > front_speed <b>": "57 × 31 &gt; front_speed &lt;b&gt;",
    "`tau_bar` of k_ij": "`tau_bar` of k<sub>ij</sub>",
}
HOSTILE = """<script>f()</script> <img src=x onerror=f()> &lt;b> <http://h.i> [a](javascript:b)

<div onclick="f()">
c
</div>

![d](https://e.f/g.png) ![h][i] <!-- j --> <k@l.m> `<i>n</i>`

[i]: https://e.f/g.png
"""
CLAIM = result("3A")
REFUSED = [  # a file of fig3, what is wrong in it, and what is said
    *(
        ("claims.json", text, "claims.json is not a table of claims (")
        for text in ("[{", '{"schema": 2, "claims": [{"id": "3A"}]}')
    ),
    ("claims.json", '{"schema": 1}', "its schema is 1, not 3"),
    ("claims.json", [CLAIM | {"verdict": "partly"}], "claim 3A: not a verdict: 'partly'"),
    ("claims.json", [CLAIM, CLAIM], "a claim '3A' more than claims.toml lists"),
    ("claims.json", [CLAIM | {"id": "3Z"}], "a claim '3Z' more than claims.toml lists"),
    ("fig3.png", "no picture", "fig3.png is not a PNG"),
]


@pytest.fixture(name="project")
def made_up_project(tmp_path):
    project = Project(tmp_path)
    project.make_recipes()
    return project


def page_of(project):
    project.seal()
    done = project.report()
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"Report: {project.page}\n"
    return project.page.read_text(encoding="utf-8")


def section(page, name):
    """In one line."""
    return " ".join(re.findall(rf'<section id="{name}".*?</section>', page, re.S)[0].split())


def test_the_readme_is_updated_if_every_row_is_judged(project):
    with patch.object(report, "update_readme") as update:
        report.main(project.root)
        update.assert_not_called()
        for recipe in {table()[claim_id]["recipe"] for claim_id in NOT_RUN}:
            rows = [result(name) for name, row in table().items() if row["recipe"] == recipe]
            spill(project.results / recipe / "claims.json", json.dumps(results_of(rows)))
        project.seal()
        report.main(project.root)
    update.assert_called_once()


@pytest.fixture(name="page", scope="module")
def page_with_accounts(tmp_path_factory):
    project = Project(tmp_path_factory.mktemp("whole"))
    project.make_recipes()
    project.make_accounts()
    spill(project.results / "fig2/own.json", json.dumps([OWN, EXPECTED]))
    return page_of(project)


def test_all_that_the_page_shows_and_leads_to_is_beside_it(project):
    project.make_accounts()
    spill(project.results / "fig2/movie.gif", "GIF")
    page = page_of(project)
    ids = re.findall(r'\bid="([^"]*)"', page)
    assert len(ids) == len({*ids})
    images = re.findall("<img[^>]*>", page)
    assert all(re.search(r'\balt="', image) for image in images)
    shown = {project.results / re.findall(r'\bsrc="([^"/.][^"]*)"', image)[0] for image in images}
    pictures = [*project.results.glob("**/[!.]*.png"), *project.results.glob("*/*.gif")]
    assert shown == {*pictures}
    for address in re.findall(r'\b(?:href|src)="(?!data:|https://arxiv)([^"]*)"', page):
        name = address.removeprefix("#")
        assert name in ids if name != address else (project.results / name).is_file(), address


@pytest.mark.parametrize("name, text", SAYS)
def test_sections_say(page, name, text):
    assert text in section(page, name)


def test_lists_every_judged_claim_in_order(page):
    ids = re.findall(r'<tr id="claim-([^"]+)"', page)
    assert ids == JUDGED
    chips = re.findall(r'href="#result-([\w-]+)"\s+aria-label', section(page, "gallery"))
    assert sorted(chips) == sorted(JUDGED)
    counts = [int(count) for count in re.findall(r"<strong>(\d+)</strong>", page)]
    checks = sum(table()[claim_id]["kind"] == "check" for claim_id in JUDGED)
    assert counts == [len(JUDGED) - checks, checks - 1, 1]  # reproduced; reproduced, differs
    assert f"{len(JUDGED)} of {len(table())} findings and checks" in page


def test_orders_recipes_as_the_paper_does_each_with_its_picture(page):
    names = re.findall(r'<section id="([^"]+)"', page)
    assert names == ["gallery", *RECIPES, "claims", "numbers", "verdicts", "build"]
    card = r'<a class="card" href="#(\w+)">\s*<span class="thumbnail"><img src="([^"]+)"'
    assert re.findall(card, page) == [(name, f"{name}/{name}.png") for name in RECIPES]


def test_leaves_out_what_was_not_run_and_what_belongs_elsewhere(page):
    for words in (r"\bfig5\b", r"\bfig10\b", "Figure 5", *(rf"\b{name}\b" for name in NOT_RUN)):
        assert not re.search(words, page)
    assert "<script" not in page and "<b>" not in page
    assert "movie" not in page.partition("</style>")[2]
    assert "What is done" not in section(page, "fig3")


def test_files_of_others_are_not_replaced(project):
    for name in ("index.html", "ro-crate-metadata.json", "claims.png"):
        path = (project.results / name).resolve()
        path.symlink_to("mine")
        done = project.report()
        assert (done.returncode, done.stderr.count("\n")) == (1, 1)
        assert f"report: {path} is not in" in done.stderr
        assert path.readlink().name == "mine"
        path.unlink()
    project.page.write_text("mine")
    assert project.report().returncode == 1
    assert project.page.read_text() == "mine"
    project.page.unlink()
    page_of(project)
    page_of(project)


@pytest.mark.parametrize("caption, shown", CAPTIONS)
def test_captions_hold_numbers_and_leave_out_sentences_without_any(project, caption, shown):
    readme = project.root / "recipes/fig2/README.md"
    spill(readme, f"# Title\n\n## Caption\n\n{caption}\n")
    assert shown in section(page_of(project), "fig2")


@pytest.mark.parametrize("text", TYPESET)
def test_symbols_are_unicode_and_other_words_are_left(text):
    assert typeset(text) == TYPESET[text]


def test_alternative_texts_are_the_first_sentence_about_the_picture():
    caption = "Above <t_R> and Eq. S1. More.\n\n- **C** (`c.png`, `d.csv`): no; *yes*.\n"
    caption += "- `b.png`: it. No.\n"
    assert seen("a.png", "T", caption) == "T. Above ⟨t_R⟩ and Eq. S1."
    assert seen("b.png", "T", caption) == "T. it."
    assert seen("c.png", "T", caption) == "T. C: no; yes."


def tags_in(page):
    return {*re.findall(r"<(/?\w+)", page)}


def test_html_in_texts_is_shown_as_text(project):
    page = as_html(HOSTILE, ())
    assert tags_in(page) == {"p", "/p", "code", "/code", "a", "/a"}
    assert {*re.findall('href="([^"]*)', page)} == {"https://e.f/g.png"}
    spill(project.root / "recipes/fig2/README.md", f"# {HOSTILE}\n## Caption\n\n{HOSTILE}")
    path = project.results / "fig2/claims.json"
    rows = json.loads(path.read_text())
    rows["claims"][0] |= dict.fromkeys(("paper", "reason", "note", "acceptance"), HOSTILE)
    rows["claims"][0]["measured"] = {HOSTILE: HOSTILE}
    before = tags_in(page_of(project))
    path.write_text(json.dumps(rows))
    after = page_of(project)
    assert tags_in(after) <= before and "&lt;script&gt;f()" in after
    assert not re.search(r"<[^>]*\son(click|error)=", re.sub(r'"[^"]*"', "", after))


def test_measured_texts_are_no_markdown():
    text = "[a](javascript:b) ![c](https://d.e/f.png) *g* <https://h.i>"
    claim = types.SimpleNamespace(id="2A", measured={"type": text})
    shown = as_html(filled("It is {2A: type}.", [claim]), ())
    assert tags_in(shown) == {"p", "/p"} and "[a](javascript:b)" in shown


@cache
def names_in(path):
    """A pattern for each text in Python that may name a quantity; what is inserted may be all."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        parts: list[ast.AST] = [*node.values] if isinstance(node, ast.JoinedStr) else [node]
        texts = [part.value if isinstance(part, ast.Constant) else None for part in parts]
        if any(isinstance(text, str) and re.search("[a-z]{2}|R", text) for text in texts):
            found.add("".join(".+" if text is None else re.escape(str(text)) for text in texts))
    return found


@pytest.mark.parametrize("recipe", [*recipe_names(ROOT), "README"])
def test_every_placeholder_names_a_claim_or_an_own_result_and_its_quantity(recipe):
    if recipe == "README":
        text, scripts = readme.SENTENCES, [*(ROOT / "recipes").rglob("*.py")]
        known = table()
        ids = {*known, "choices", "precursors", "places", "kinds", "findings", "checks", "first"}
    else:
        folder, known = ROOT / "recipes" / recipe, table(paper_of(recipe))
        text = (folder / "README.md").read_text(encoding="utf-8").partition("## Caption")[2]
        shared = [*(ROOT / "recipes").glob("*.py"), *(ROOT / "recipes/measure").rglob("*.py")]
        scripts = [*folder.glob("*.py"), *shared]
        ids = {claim for claim, row in known.items() if row["recipe"] == recipe}
        texts = (path.read_text(encoding="utf-8") for path in folder.glob("*.py"))
        ids |= set(re.findall(r'(?:OwnResult|compared)\(\s*(?:id=)?"(\w+)"', "".join(texts)))
    places, names = PLACE.findall(text), set().union(*map(names_in, scripts))
    assert {claim for claim, _ in places} <= ids
    for claim, quantity in places:
        quantity = " ".join(quantity.split())
        if quantity in (*known.get(claim, {}).get("counts", ()), "holds", "samples"):
            continue
        if claim in known:
            path = Path(
                inspect.getfile(function_of(known[claim]["recipe"], known[claim]["measured"]))
            )
            names = names | names_in(path)
        parts = quantity.split(": ")
        ends = [": ".join(parts[n:]) for n in range(len(parts))]
        assert any(re.fullmatch(name, end) for name in names for end in ends), quantity


def test_the_picture_of_all_claims_shows_them_as_they_are(project):
    picture, claims = project.results / "claims.png", project.results / "fig2/claims.json"
    page_of(project)
    drawn = picture.read_bytes()
    claims.write_text(claims.read_text().replace('"shown": "holds"', '"shown": "does not hold"'))
    page_of(project)
    assert picture.read_bytes() != drawn
    assert picture.with_suffix(".pdf").exists()


@pytest.mark.parametrize("name, content, sentence", REFUSED)
def test_a_recipe_that_cannot_be_shown_is_left_out_with_a_sentence(
    project, name, content, sentence
):
    project.seal()
    text = content if isinstance(content, str) else json.dumps(results_of(content))
    (project.results / "fig3" / name).write_text(text)
    for sentence in (f"fig3/{name} is gone, or not as it was written", sentence):
        done = project.report()
        assert (done.returncode, done.stderr.count("\n")) == (0, 1)
        assert f"{sentence}" in done.stderr
        assert done.stderr.endswith(": left out until ./reproduce.sh fig3 has made it again\n")
        text = project.page.read_text(encoding="utf-8")
        assert 'id="fig3"' not in text and 'id="fig2"' in text
        project.seal()


def test_a_place_in_a_caption_that_names_nothing_is_an_error():
    found = [types.SimpleNamespace(id="2A", measured={"type": "slow"})]
    assert filled("A {2A: type}. B {own: size}.", found).strip() == "A slow."
    with pytest.raises(Failure, match="A caption has {2A: kind}, which 2A does not measure."):
        filled("A {2A: type}, {2A: kind}.", found)


def claim(kind, verdict, shown="holds"):
    return Claim("3D", kind, "today", "it is so", "", {}, shown, [], verdict, "")


@pytest.mark.parametrize(
    "claims, text",
    [
        ([], ""),
        ([claim("check", "reproduced")], ""),
        (
            [claim("finding", None)] * 9 + [claim("finding", None, "does not hold")],
            "Without a verdict, 9 of 10 hold for what is shown: one event or set; a verdict needs"
            " other runs.",
        ),
        (
            [claim("finding", word) for word in ("differs", "in part", "reproduced")] * 2,
            "Findings of the paper with a verdict: 6, of which 2 reproduced, 2 in part, 2 differs."
            " What differs: 3D (it is so); 3D (it is so).",
        ),
        ([claim("finding", None, None)], ""),
    ],
)
def test_the_first_sentence_says_what_was_judged(claims, text):
    assert report.in_words(claims) == text


def test_an_empty_page_says_what_to_run(tmp_path):
    page = page_of(Project(tmp_path))
    assert "./reproduce.sh all" in page
    assert '<section id="gallery"' not in page
