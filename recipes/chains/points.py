"""The points of chains: their values, their filled commands, and what they come from.

A point is its commands, the files that it keeps, and its base; its name, a digest of these, is that
of its files in results/data/points. What a command needs from reports is filled in when it runs."""

import itertools
import json
import os
import re
import shlex
from contextlib import suppress
from functools import cached_property
from pathlib import Path

from chains.chain import BASE, kept_names
from chains.expressions import Expression, as_number, as_text, first_known
from chains.ini import existing
from chains.point import HOLE
from chains.store import STORE, digest, digest_of_tool, is_current, origin_of, result_of
from chains.store import sources_of, tools_of
from chains.values import is_expression
from rupture.errors import UsageError

LAST_BEFORE = "last before "


class Waiting(Exception):
    """Raised for what depends on reports that are not there yet."""


def each(function, points):
    """Calls function(point) for all points, then raises Waiting if one of them waits for a report:
    so all these reports are asked for at once."""
    found, waiting = [], None
    for point in points:
        try:
            found.append(function(point))
        except Waiting as what:
            waiting = what
    if waiting:
        raise waiting
    return found


def those(is_so, points):
    """The points for which it is so."""
    return [*itertools.compress(points, each(is_so, points))]


class Point:
    """`of`: the point that it comes from, whose names it has, too; `elements`: {name: one of the
    elements of a list of its report}; `decides`: whether its report decides about other points."""

    decides = False

    def __init__(self, chain, values, of=None, elements=()):
        self.chain, self.values, self.of, self.elements = chain, values, of, dict(elements)

    @property
    def lineage(self):
        """This point, the one that it comes from, and so on."""
        return [self, *(self.of.lineage if self.of else [])]

    # --- names ---------------------------------------------------------------------------------

    @cached_property
    def names(self):
        points = self.lineage
        return {n for one in points for n in (*one.values, *one.chain.commands, *one.elements)}

    def known(self, name):
        """What a name means for points that come from this one."""
        if name in self.chain.commands:
            return self.report(name)
        return self.value(name, self.known)

    def look_up(self, name):
        """What a name means here before any command has run."""
        if name in self.chain.commands:
            raise Waiting(name)
        return self.value(name, self.look_up)

    def value(self, name, look_up):
        if name in self.values:
            text = self.values[name]
            return self.worked_out(text[1:-1], look_up) if is_expression(text) else as_number(text)
        if name in self.elements:
            return self.elements[name]
        if self.of:
            return self.of.known(name)
        raise KeyError(name)

    def worked_out(self, text, look_up):
        return Expression(text, self.names).value(look_up)

    def text(self, hole, look_up=None):
        """What replaces a hole; None if it is null. A value stays as it is written."""
        for point in self.lineage:
            written = point.values.get(hole, "{}")
            if not is_expression(written) and written != "{}":
                return written
        found = self.worked_out(hole, look_up or self.look_up)
        return None if found is None else as_text(found)

    def texts(self, look_up):
        """{name: its value as a text}, with those of the points that it comes from; None if that is
        null, or not known yet."""
        found: dict[str, str | None] = {}
        for name in (name for point in reversed(self.lineage) for name in point.values):
            found[name] = None
            with suppress(Waiting, ValueError):
                found[name] = self.text(name, look_up)
        return found

    def report(self, name):
        """Null for a point that failed. What is asked for decides about other points."""
        self.decides = True
        try:
            return self.reports.get(name)
        except OSError:
            raise Waiting(self.path) from None

    @cached_property
    def reports(self):
        return result_of(self.path)["reports"]

    # --- commands ------------------------------------------------------------------------------

    @cached_property
    def options(self):
        """Values that nothing else names, for {values}."""
        lists = [text[1:-1] for text in self.values.values() if is_expression(text)]
        holes = [hole for line in self.chain.commands.values() for hole in HOLE.findall(line)]
        named = {n for hole in (*holes, *lists) for n in Expression(hole, self.names).names}
        named = {first_known(name, self.names) for name in named}
        texts = {name: self.option(name) for name in self.values if name not in named}
        return {name: text for name, text in texts.items() if text is not None}

    def option(self, name):
        """None if it is null, or follows from what the point itself is to report."""
        try:
            return self.text(name)
        except Waiting as what:
            if what.args[0] not in self.chain.commands:
                raise
        return None

    def filled(self, line):
        """A command as it is typed; holes that wait for reports, or are null, stay."""

        def fill(found):
            if found[1] == "values":
                return as_options(self.options)
            if found[1] == "base":
                return shlex.quote(self.base["shown"])
            try:
                text = self.text(found[1])
            except Waiting:
                return found[0]
            return found[0] if text is None else shlex.quote(text)

        return HOLE.sub(fill, line)

    @cached_property
    def commands(self):
        found = {}
        for name, line in self.chain.typed.items():
            with self.chain.errors_at("commands", name):
                found[name] = self.filled(line)
        return found

    def waits_for(self, texts, found):
        """{name: [value], or the file with the report} for the names in holes that are left."""
        for dotted in (name for text in texts for name in Expression(text, self.names).names):
            name = first_known(dotted, self.names)
            if name in found or name in self.chain.commands:
                continue
            if is_expression(self.values.get(name, "")):
                found[name] = self.values[name]
                self.waits_for([self.values[name][1:-1]], found)
            else:
                found[name] = self.source(name)
        return found

    def source(self, name):
        try:
            return [self.look_up(name)]
        except Waiting:
            return str(next(p for p in self.lineage[1:] if name in p.chain.commands).path)

    # --- where it starts, and what it is --------------------------------------------------------

    @cached_property
    def base(self):
        """Its file, how commands name it, and the point that kept it; None without one."""
        if "base" not in self.chain.keys:
            return None
        with self.chain.errors_at("chain", "base"):
            chain, name = BASE.findall(self.chain.keys["base"])[0]
            path = existing(Path(os.path.abspath(self.chain.path.parent / f"{chain}.ini")))
            for kept in self.lineage[1:]:
                if chain and kept.chain.path == path:
                    name = self.kept_file(kept, name)
                    return {"file": str(kept.file(name)), "shown": name, "of": str(kept.path)}
            path = self.chain.path.parent / HOLE.sub(lambda hole: self.text(hole[1]), name)
            file = self.chain.start_at(existing(path))
            return {"file": file, "shown": file, "of": ""}

    def kept_file(self, kept, text):
        """The file of that point which `base` asks for."""
        if hole := next((h for h in HOLE.findall(text) if h.startswith(LAST_BEFORE)), ""):
            time = self.worked_out(hole.removeprefix(LAST_BEFORE), self.look_up)
            start, end = text.split("{%s}" % hole)
            found = [n for n in kept.chain.keep if n.startswith(start) and n.endswith(end)]
            times = {float(name[len(start) : len(name) - len(end)]): name for name in found}
            earlier = [at for at in times if time is not None and at < time]
            if not earlier:
                raise UsageError(f"{kept.chain.shown} keeps no {text} before {time}")
            return times[max(earlier)]
        plain = re.sub(r"\{([^{}]*[^{}\d.][^{}]*)\}", lambda hole: self.text(hole[1]), text)
        return kept_names(plain)[0]  # with times, which stayed in their braces

    @cached_property
    def work(self):
        """What point.py needs to compute it."""
        holes = [hole for line in self.commands.values() for hole in HOLE.findall(line)]
        return {
            "commands": self.commands,
            "names": self.waits_for(holes, {}),
            "keep": self.chain.keep,
            "base": self.base,
        }

    @property
    def tools(self):
        return tools_of(self.commands.values())

    @property
    def inputs(self):
        """Files of other points, or of the user, on which its result depends."""
        base = [self.base["file"], self.base["of"]] if self.base else []
        return [file for file in (*base, *sources_of(self.work)) if file]

    @cached_property
    def id(self):
        return digest(json.dumps(self.work))

    @property
    def path(self):
        """Where its result is, a JSON file."""
        return STORE / f"{self.id}.json"

    def file(self, name):
        """Where a file that it keeps stays."""
        return STORE / f"{self.id}.{name}"

    @property
    def is_done(self):
        """Whether its result is there, and came from what it would come from now."""
        try:
            origin = origin_of(self.work, map(digest_of_tool, self.tools))
        except (OSError, ValueError):  # of what it starts from
            return False
        kept = map(self.file, self.chain.keep)
        return is_current(self.path, origin) and all(map(Path.exists, kept))

    @property
    def described(self):
        texts = self.texts(self.look_up).items()
        values = ", ".join(f"{name} {text}" for name, text in texts if text is not None)
        return f"{self.chain.name}: {values}" if values else self.chain.name


def as_options(values):
    """The values as options of a tool."""
    return " ".join(
        f"--set {shlex.quote(f'{name}={value}')}"
        if "." in name
        else f"--{name} {shlex.quote(value)}"
        for name, value in values.items()
        if name != "variant"
    )
