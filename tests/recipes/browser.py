"""Opens a page in headless Chromium, without any network, and says what audit.js finds in it. The
page is in a frame that is as wide as a window would be: windows themselves have a least width."""

import html
import json
import os
import re
import subprocess
from pathlib import Path
from urllib.parse import unquote

from conftest import need

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
