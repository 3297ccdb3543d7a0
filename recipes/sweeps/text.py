"""The file of a sweep as text: its sections, and what is wrong in a sentence with the line."""

import re
from contextlib import contextmanager

from rupture.errors import Failure, UsageError
from rupture.tools.command_line import check_known, is_seen
from rupture.units import one_name

SECTIONS = ("sweep", "commands", "values", "quantities")
KEYS = ("title", "base", "points", "keep", "axis", "memory", "threads")
LARGEST = 100_000_000  # bytes
COMMENT = re.compile(r"(^|\s)[#;].*")
HEADER = re.compile(r"\[(.*)\]")


def check_letters(text):
    for letter in text:
        if not is_seen(letter):
            raise UsageError(f"there is a control character, U+{ord(letter):04X}: delete it")


def name_of(path):
    """The name of its results."""
    check_letters(path.stem)
    if path.stem.startswith(".") or len(path.stem.encode()) > 200:
        raise UsageError(f"{path}: rename the file: its results take its name")
    return path.stem


def existing(path):
    """The file at this path, or at one of the same look."""
    if path.exists() or not (folder := existing(path.parent)).is_dir():
        return path
    same = (one for one in folder.iterdir() if one_name(one.name) == one_name(path.name))
    return next(same, path)


@contextmanager
def errors_of(path):
    """Raises one sentence with the file: UsageErrors, but a Failure if the system refuses."""
    try:
        yield
    except OSError as error:
        raise Failure(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise UsageError(f"{path}: it is not UTF-8 text") from None


def read_text(path):
    """Of a file that ends."""
    with errors_of(path):
        if path.stat().st_size > LARGEST or not path.is_file():
            raise UsageError(f"{path}: it is no file of up to {LARGEST // 10**6} MB")
        return one_name(path.read_text(encoding="utf-8-sig")).replace("\t", " ")


def is_values(section):
    return section == "values" or section.startswith("variant ")


class Text:
    """`sections`: {section: {name: text}} in the order of the file."""

    def __init__(self, path):
        self.path = path
        self.sections: dict[str, dict[str, str]] = {}
        self.lines: dict[tuple[str, str], int] = {}
        self.text = read_text(path)
        section = name = ""
        for number, line in enumerate(self.text.split("\n"), 1):
            with self.errors_in(number):
                check_letters(line)
                line = COMMENT.sub("", line).rstrip()
                if line.startswith(" ") and name:
                    self.sections[section][name] += f" {line.strip()}"
                elif line:
                    section, name = self.add(section, line.strip(), number)
        for (section, name), number in self.lines.items():
            if name and not self.sections[section][name]:
                raise self.error(number, f"'{name}' in [{section}] has no value")

    def add(self, section, line, number):
        """The section and the name of a line."""
        if header := HEADER.fullmatch(line):
            section, name = " ".join(header[1].split()), ""
            if not is_values(section):
                check_known(section, SECTIONS, "there is no section")
            is_there, what = section in self.sections, f"the section [{section}]"
            self.sections.setdefault(section, {})
        else:
            name, equals, text = (part.strip() for part in line.partition("="))
            if not section or not equals or not name:
                expected = "NAME = VALUE or [SECTION]" if section else "[SECTION] first"
                raise UsageError(f"expected {expected} (got '{line}')")
            if section == "sweep":
                check_known(name, KEYS, "[sweep] has no key")
            is_there, what = name in self.sections[section], f"'{name}' in [{section}]"
            self.sections[section][name] = text
        if is_there:
            raise UsageError(f"{what} is there twice: keep one")
        self.lines[section, name] = number
        return section, name

    def __getitem__(self, section):
        return self.sections.get(section, {})

    def error(self, number, sentence):
        where = f"{self.path}, line {number}" if number else f"{self.path}"
        return UsageError(f"{where}: {sentence}")

    @contextmanager
    def errors_in(self, number):
        try:
            yield
        except (Failure, ValueError) as error:
            if str(error).startswith(f"{self.path}"):
                raise
            raise self.error(number, error) from None

    def errors_at(self, section, name=""):
        return self.errors_in(self.lines.get((section, name)) or self.lines.get((section, "")))
