"""Opens a page in headless Chromium, without any network, and says what happened."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

TIMEOUT = 240  # [s], of a busy machine
HEIGHT = 900  # of the window [pixels]
ARGUMENTS = (
    "--headless=new",
    "--no-sandbox",  # needs no user namespaces: containers run this as root
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--host-resolver-rules=MAP * ~NOTFOUND",
)
AUDIT = (Path(__file__).parent / "audit.js").read_text(encoding="utf-8")
SEEN = """return {
  images: Array.from(document.images, (image) => [image.src, image.naturalWidth]),
  ids: Array.from(document.querySelectorAll("[id]"), (element) => element.id),
  requests: performance.getEntriesByType("resource").map((entry) => entry.name),
  text: document.body.innerText,
};"""
AXE = """const done = arguments[0];
axe.run().then((found) => done(found.violations.map((rule) => `axe: ${rule.id}: ${rule.help}`)));"""


@dataclass(frozen=True)
class Seen:
    images: list  # [address, natural width in pixels]
    ids: list
    requests: list
    text: str
    errors: list  # of the console
    faults: list  # that audit.js finds, and axe-core if RUPTURE_AXE names its axe.min.js

    def missing_images(self):
        return [address for address, width in self.images if width == 0]

    def foreign_requests(self):
        """Whatever does not come from this page or the file system."""
        return [address for address in self.requests if not re.match(r"(file|data):", address)]


class Browser:
    def __init__(self, program):
        options = webdriver.ChromeOptions()
        for argument in ARGUMENTS:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(program), options=options)
        self.driver.set_page_load_timeout(TIMEOUT)

    def close(self):
        self.driver.quit()

    def show_as(self, width, scheme):
        """The width of the window [pixels], and the scheme that its user prefers."""
        size = {"width": width, "height": HEIGHT, "deviceScaleFactor": 1, "mobile": False}
        preference = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", preference)

    def axe(self):
        """Of axe-core, which Debian has no package of."""
        path = os.environ.get("RUPTURE_AXE")
        if not path:
            return []
        self.driver.execute_script(Path(path).read_text(encoding="utf-8"))
        return self.driver.execute_async_script(AXE)

    def look(self, page, width=1400, scheme="light"):
        self.show_as(width, scheme)
        self.driver.get(page.as_uri())
        seen = self.driver.execute_script(SEEN)
        errors = [entry["message"] for entry in self.driver.get_log("browser")]
        faults = self.driver.execute_script(AUDIT) + self.axe()
        return Seen(**seen, errors=errors, faults=faults)
