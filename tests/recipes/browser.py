# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Opens a page in headless Chromium, without any network, and says what happened."""

import html
import json
import re
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

TIMEOUT = 240  # [s], of a busy machine

# Goes in front of everything else in a copy of the page, whose links still start from the folder of
# the original. Its findings are left in an attribute of <html>, which --dump-dom prints.
WATCHER = """
<base href="{folder}/">
<script>
const errors = [];
addEventListener("error", (event) => {{
  errors.push(event.message || "failed to load: " + (event.target.src || event.target.href));
}}, true);
addEventListener("securitypolicyviolation", (event) => errors.push(event.violatedDirective));
for (const level of ["error", "warn"]) {{
  console[level] = (...words) => errors.push(words.join(" "));
}}
addEventListener("load", () => {{
  document.documentElement.dataset.seen = JSON.stringify({{
    images: Array.from(document.images, (image) => [image.src, image.naturalWidth]),
    ids: Array.from(document.querySelectorAll("[id]"), (element) => element.id),
    requests: performance.getEntriesByType("resource").map((entry) => entry.name),
    text: document.body.innerText,
    errors,
  }});
}});
</script>
"""


@dataclass(frozen=True)
class Seen:
    images: list  # [address, natural width in pixels]
    ids: list
    requests: list
    text: str
    errors: list

    def missing_images(self):
        return [address for address, width in self.images if width == 0]

    def foreign_requests(self):
        """Whatever does not come from this page or the file system."""
        return [address for address in self.requests if not re.match(r"(file|data):", address)]


def dump(chromium, page, profile):
    """The document after it was loaded, and what Chromium's console said."""
    return subprocess.run(
        [
            chromium,
            "--headless=new",
            "--no-sandbox",  # needs no user namespaces: containers run this as root
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-background-networking",
            "--no-first-run",
            "--host-resolver-rules=MAP * ~NOTFOUND",
            "--enable-logging=stderr",
            f"--user-data-dir={profile}",
            "--dump-dom",
            page.as_uri(),
        ],
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
    )


def look(chromium, page):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        watched = Path(folder) / "page.html"
        text = page.read_text(encoding="utf-8")
        watcher = WATCHER.format(folder=page.parent.as_uri())
        watched.write_text(text.replace("<head>", "<head>" + watcher, 1), encoding="utf-8")
        output = dump(chromium, watched, Path(folder) / "profile")
    found = re.search(r'data-seen="([^"]*)"', output.stdout)
    if not found:
        raise AssertionError(f"Chromium did not load {page}:\n{output.stderr[-2000:]}")
    seen = Seen(**json.loads(html.unescape(found[1])))
    seen.errors.extend(re.findall(r"CONSOLE.*", output.stderr))
    return seen
