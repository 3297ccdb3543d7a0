"""The links of a page, and those that lead nowhere."""

import re
from html.parser import HTMLParser
from urllib.parse import unquote


class Links(HTMLParser):
    def __init__(self, page):
        super().__init__()
        self.folder = page.parent
        self.ids, self.hrefs, self.sources = [], [], []
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag == "a":
            self.hrefs.append(attributes["href"])
        elif tag == "link":
            self.sources.append(attributes["href"])
        if "src" in attributes:
            self.sources.append(attributes["src"])

    def leads_somewhere(self, address):
        if address.startswith("#"):
            return address[1:] in self.ids
        return "://" in address or (self.folder / unquote(address)).exists()

    def broken(self):
        return [
            a for a in self.hrefs + self.sources if not (a == "data:," or self.leads_somewhere(a))
        ]

    def outside(self):
        """Files that are left behind when the folder of the page is copied alone."""
        files = [a for a in self.hrefs + self.sources if not re.match(r"[a-z]+:|#", a)]
        here = self.folder.resolve()
        return [a for a in files if not (here / unquote(a)).resolve().is_relative_to(here)]

    def foreign_sources(self):
        return [a for a in self.sources if "//" in a]
