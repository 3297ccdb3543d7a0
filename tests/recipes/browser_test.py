"""The report in a browser: it loads completely from the file system alone, and nothing bars readers
from it in wide and narrow windows, light and dark. The same checks must fail when something is
wrong. The page is in a frame that is as wide as a window would be: windows themselves have a least
width. audit.js says what bars readers."""

import html
import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from urllib.parse import unquote

import pytest

from conftest import need
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

TIMEOUT = 240  # [s], of a busy machine
ARGUMENTS = (
    *("chromium", "--headless", "--window-size=1500,900"),
    "--no-sandbox",  # needs no user namespaces: containers run this as root
    *("--disable-gpu", "--disable-dev-shm-usage", "--disable-background-networking"),
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--allow-file-access-from-files",  # the outer page looks into the frame
    *("--enable-logging=stderr", "--virtual-time-budget=60000", "--dump-dom"),
)
FRAME = """<!DOCTYPE html>
<meta name="color-scheme" content="light dark">
<iframe src="%s" width="%d" height="900" style="border: 0"></iframe>
<pre></pre>
<script>
addEventListener("load", async () => {
  const Own = document.querySelector("iframe").contentWindow.Function;
  const found = Own(%s)();
  Own(%s)();
  const axe = await Own("return window.axe?.run()")();
  for (const rule of axe?.violations ?? []) found.faults.push(`axe: ${rule.id}: ${rule.help}`);
  document.querySelector("pre").textContent = JSON.stringify(found);
});
</script>
"""


def script(path):
    return json.dumps(Path(path).read_text(encoding="utf-8")).replace("</", "<\\/")


def strays(page, addresses):
    """Files that do not exist, or are left behind when the folder of the page is copied alone."""
    here = page.parent.resolve()
    names = [one.partition("#")[0] for one in addresses if one.startswith("file:")]
    paths = [Path(unquote(name.removeprefix("file://"))).resolve() for name in names]
    return [path for path in paths if not (path.exists() and path.is_relative_to(here))]


def look(folder, page, width=1400, scheme="light"):
    """{faults, images, files, ground: the colour of the page}. All rules of axe-core, which Debian
    has no package of, are among the faults if RUPTURE_AXE names its axe.min.js."""
    need("chromium")
    scripts = [
        script(Path(__file__).with_name("audit.js")),
        script(os.environ.get("RUPTURE_AXE", os.devnull)),
    ]
    outer = folder / "frame.html"
    outer.write_text(FRAME % (page.as_uri(), width, *scripts), encoding="utf-8")
    dark = f"--blink-settings=preferredColorScheme={0 if scheme == 'dark' else 1}"
    words = [*ARGUMENTS, f"--user-data-dir={folder}/profile", dark, outer.as_uri()]
    done = subprocess.run(words, capture_output=True, text=True, check=True, timeout=TIMEOUT)
    found = json.loads(html.unescape(re.findall("<pre>(.*)</pre>", done.stdout, re.S)[0]))
    found["faults"] += [f"stray file: {path}" for path in strays(page, found["files"])]
    found["faults"] += re.findall(r"CONSOLE.*", done.stderr)
    return found


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
