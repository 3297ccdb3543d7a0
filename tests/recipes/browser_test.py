"""The report in a browser: it loads completely from the file system alone, and nothing bars readers
from it in wide and narrow windows, light and dark. The same checks must fail when something is
wrong."""

import shutil

import pytest

from browser import look
from fixture import Project, png, spill

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
    '<img alt="" src="https://example.org/a.png">': "request to https://example.org/a.png",
    '<img alt="" src="no.png">': 'picture is missing: <img alt="" src="no.png">',
    '<a href="#nowhere">x</a>': "link leads nowhere",
    '<a href="no.csv">x</a>': "moved/no.csv",
    '<a href="../frame.html">x</a>': "frame.html",
    '<script>console.error("x")</script>': '"x"',
}


@pytest.fixture(scope="module", name="page")
def moved_page(tmp_path_factory):
    """That of made-up results, which were moved elsewhere."""
    folder = tmp_path_factory.mktemp("page")
    project = Project(folder / "made")
    project.make_recipes()
    project.make_accounts()
    spill(project.results / "fig2/movie.gif", png(40, 30))  # browsers look at the content
    assert project.report().returncode == 0
    return shutil.move(project.results, folder / "moved") / "index.html"


@pytest.mark.parametrize("width, scheme", WAYS)
def test_nothing_bars_readers(tmp_path, page, width, scheme):
    seen = look(tmp_path, page, width, scheme)
    assert seen["faults"] == []
    files = [*page.parent.glob("**/[!.]*.png"), page.parent / "fig2/movie.gif"]
    assert set(seen["images"]) == {path.as_uri() for path in files}
    assert (seen["ground"] == "rgb(255, 255, 255)") == (scheme == "light")


def test_what_bars_readers_is_noticed(tmp_path, page):
    folder = shutil.copytree(page.parent, tmp_path / "moved")
    text = page.read_text(encoding="utf-8")
    worse = folder / "worse.html"
    worse.write_text(text.replace("</main>", "".join(PLANTED) + "</main>"), encoding="utf-8")
    faults = look(tmp_path, worse)["faults"]
    missed = [name for name in PLANTED.values() if not any(name in fault for fault in faults)]
    assert missed == []
