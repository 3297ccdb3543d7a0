"""Files of users' sweeps as they are written (docs/sweeps.md): sections, keys, and which line says
what."""

import os
import re
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path

from chains.point import HOLE
from chains.store import RESULTS, write_own
from rupture.errors import Failure, UsageError
from rupture.programs import output_of
from rupture.units import one_name
from chains.programs import PLAIN
from chains.ini import check_known, errors_of, existing, is_values, needs_of, new_ini
from chains.values import is_expression, values_of

SECTIONS = ("chain", "commands", "values", "quantities", "units")
KEYS = ("title", "like", "points", "base", "keep", "memory", "threads", "axis")
SELECTION = re.compile(
    r"(?P<first>first )?(?:(?P<element>\w+) in )?(?P<chain>[\w./-]+?)"
    r"(?:: (?P<list>[\w.]+))?(?: where (?P<condition>.+))?"
)
BASE = re.compile(r"(?:(?P<chain>[\w./-]+): )?(?P<file>.+)")


class Chain:
    """One file. `own`: the sections in the file itself, `sections`: with those of the files that it
    is like."""

    def __init__(self, path, read=()):
        self.path = Path(os.path.abspath(path))
        self.copies: dict[Path, str] = {}  # of files from which points start
        if self.path in read:
            raise UsageError(f"{self.shown}: 'like' leads back to the same file")
        if not self.path.exists():
            beside = ", ".join(sorted(one.stem for one in self.path.parent.glob("*.ini")))
            raise UsageError(f"there is no chain {self.shown}; beside it are {beside or 'none'}")
        with errors_of(self.shown):
            ini = new_ini()
            ini.read_string(one_name(self.path.read_text(encoding="utf-8-sig")), str(self.path))
            self.own = {  # what goes on in an indented line is one text
                name: {key: " ".join(text.splitlines()) for key, text in ini[name].items()}
                for name in ini.sections()
            }
        is_sweep = "sweep" in self.own  # as files of version 0.4 call it
        if is_sweep:
            self.own["chain"] = self.own.pop("sweep")
        self.check_form("sweep" if is_sweep else "chain")
        self.sections = dict(self.own)
        if like := self.own.get("chain", {}).get("like"):
            other = Chain(existing(self.path.parent / like), (*read, self.path))
            kinds = {name.partition(" ")[0] for name in self.own}
            for name, section in other.sections.items():
                if name.partition(" ")[0] not in kinds:
                    self.sections[name] = section
            keys = {k: t for k, t in other.keys.items() if k != "like" and not is_sweep}
            self.sections["chain"] = keys | self.own["chain"]

    @property
    def shown(self):
        """The file, as errors name it."""
        return str(self.path)

    @property
    def name(self):
        return self.path.stem

    @property
    def keys(self):
        return self.sections.get("chain", {})

    @cached_property
    def commands(self):
        """{name: command}, as they are written."""
        lines = self.sections.get("commands", {})
        return {name: line.removeprefix("rupture ") for name, line in lines.items()}

    @cached_property
    def typed(self):
        """The commands with names of checkpoints (x-t{0.2}.h5) as programs write them."""
        return {
            name: re.sub(r"(?<=-t)\{([\d.]+)\}(?=\.h5)", lambda at: time_in_name(at[1]), line)
            for name, line in self.commands.items()
        }

    @cached_property
    def lists(self):
        """{section: {name: texts}}: the values of [values] and of each variant."""
        found: dict[str, dict] = {}
        for section in filter(is_values, self.sections):
            found[section] = {}
            for name, text in self.sections[section].items():
                with self.errors_at(section, name):
                    found[section][name] = [text] if is_expression(text) else values_of(text)
        return found

    @cached_property
    def points(self):
        """What `points` says, by the names in SELECTION; None for what it does not say."""
        text, nothing = self.keys.get("points", ""), dict.fromkeys(SELECTION.groupindex)
        found = SELECTION.fullmatch(text)
        if not text or (not found and text.endswith(".csv")):  # any name of a file
            return nothing | {"chain": text}
        if not found or bool(found["element"]) != bool(found["list"]):
            sentence = "write points = CHAIN, or NAME in CHAIN: LIST; then where CONDITION"
            raise self.error("chain", "points", sentence)
        return found.groupdict()

    @property
    def table(self):
        """The file if its points are the rows of a table."""
        name = self.points["chain"]
        return existing(self.path.parent / name) if name.endswith(".csv") else None

    @cached_property
    def keep(self):
        """Names of files that stay, with all checkpoints of a list of times."""
        with self.errors_at("chain", "keep"):
            return [name for word in self.keep_words for name in kept_names(word)]

    @property
    def keep_words(self):
        return re.findall(r"(?:\{[^{}]*\}|\S)+", self.keys.get("keep", ""))

    @property
    def needs(self):
        """Megabytes and threads of a point."""
        with self.errors_at("chain", "memory" if "memory" in self.keys else "threads"):
            return needs_of(self.keys)

    def start_at(self, path):
        """The file from which points start, as commands name it: a copy."""
        if path not in self.copies:
            self.copies[path] = str(copy_of(path))
        return self.copies[path]

    def line_of(self, section, key):
        """Where the file says it; 0 if another one does, which this one is like."""
        here = ""
        for number, line in enumerate(self.path.read_text(encoding="utf-8-sig").splitlines(), 1):
            if found := re.match(r"\[(.*?)\]", line := one_name(line)):
                here = "chain" if found[1] == "sweep" else found[1]
            elif here == section and re.match(rf"{re.escape(key)}\s*=", line):
                return number
        return 0

    @contextmanager
    def errors_at(self, section, key):
        """Raises one sentence with the file and the line for what is wrong there."""
        try:
            yield
        except (UsageError, ValueError) as error:
            if re.match(r"\S+\.ini[:,] ", str(error)):
                raise
            raise self.error(section, key, error) from None

    def error(self, section, key, sentence):
        where = self.shown
        if number := self.line_of(section, key):
            where += f", line {number}"
        elif key in self.sections.get(section, {}):
            where += f", '{key}'"
        return UsageError(f"{where}: {' '.join(str(sentence).split())}")

    def check_form(self, heading):
        for section, lines in self.own.items():
            with self.errors_at(section, next(iter(lines), "")):
                if not is_values(section):
                    check_known(section, SECTIONS, "there is no section")
            for key, text in lines.items():
                with self.errors_at(section, key):
                    if section == "chain":
                        check_known(key, KEYS, f"[{heading}] has no key")
                    if not text and section != "units":
                        raise UsageError(f"'{key}' in [{section}] has no value")


def copy_of(base):
    """Copies the file from which points start."""
    try:
        checksum = output_of("analyze", "checksum", base).strip()
    except Failure as failure:
        said = str(failure).removeprefix("analyze: ")
        raise UsageError(f"the base cannot be used: {said}") from None
    content = base.read_bytes()
    if not content.startswith(b"rupture-checkpoint\n"):
        raise UsageError(f"the base {base} is a record; runs continue from checkpoints")
    copy = RESULTS / "data/bases" / f"{checksum[:16]}.h5"
    write_own(copy, content)
    return copy


def time_in_name(text):
    """A time in the name of a checkpoint, as programs write it."""
    return f"{float(text):.9f}"


def kept_names(word):
    """A file; with {TIMES} in place of a time, the checkpoints that a program writes then."""
    holes = HOLE.findall(word)
    times = values_of(holes[0]) if holes else [""]
    names = [HOLE.sub(time_in_name(t), word) if holes else word for t in times]
    for name in names:
        if not PLAIN.fullmatch(name) or name.endswith(".json"):
            raise UsageError(f"'{name}' is not the name of a file in the point's own folder")
    return names
