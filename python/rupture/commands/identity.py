"""What a command is: its words, what its program computes with, and what its input files are."""

import os
import re
import shlex
from pathlib import Path

from rupture.commands.code import OURS, digest, digest_at, digest_of_function, digest_of_program
from rupture.commands.code import stamp_of
from rupture.errors import Failure, NoSuchName, UsageError

TOKEN = re.compile(r"@(?P<own>[0-9a-f]{16})/(?P<name>[\w.+-]+)")  # a made file in a command
OUTPUTS = ("-o", "--output", "--record")
PLAIN = re.compile(r"\w[\w.+-]*")
AT_TIME = re.compile(r"-t\d+\.\d{9}(?=\.\w+$)")  # of a checkpoint during a run


class Refused(Failure):
    """Why a program cannot do what a command asks for."""


class Report(dict):
    """A dict of which `report.slow.speed` is report["slow"]["speed"]."""

    def __getattr__(self, name):
        if name in self:
            return self[name]
        raise AttributeError(f"the report has no {name}; it has {', '.join(self)}")


class Made(os.PathLike):
    """A file that a command writes. Opening it makes it, if need be."""

    def __init__(self, command, name, make):
        self.command, self.name, self.make = command, name, make

    def __str__(self):
        return f"@{self.command.own}/{self.name}"

    def __fspath__(self):
        return str(self.make(self.command, self.name))


class Files:
    """The files of a command by their names in it."""

    def __init__(self, command, make):
        self.command, self.make = command, make

    def __getitem__(self, name):
        self.command.check_output(name)
        return Made(self.command, name, self.make)


class Work:
    """`line`: how one types it. `inputs`: {plain name: (id of a command, name of its file), or path
    of a user's own}."""

    def __init__(self, *known):
        sources = (f"{name}={self.said(source)}" for name, source in self.inputs.items())
        self.own = digest(*known, *sources)
        self.kept = set()

    def said(self, source):
        return "/".join(source) if isinstance(source, tuple) else self.content(source)

    def content(self, path):
        self.stamps[path] = stamp_of(path)
        return digest_at(path, self.stamps[path])

    def check_unchanged(self):
        for path, stamp in self.stamps.items():
            if stamp_of(path) != stamp:
                raise Failure(f"{path} was changed meanwhile: start again")

    def named(self, name, source):
        """A free name for an input: that of the file, or a numbered one."""
        stem, dot, ending = name.rpartition(".")
        names = [name, *(f"{stem}-{n}{dot}{ending}" for n in range(2, 999))]
        free = (one for one in names if one not in self.outputs)
        found = next(one for one in free if self.inputs.get(one, source) == source)
        self.inputs[found] = source
        return found


class Command(Work):
    """A program with its words. A word is a path if such a file exists, relative to `folder`."""

    def __init__(self, line, folder, store):
        self.inputs, self.stamps, self.folder = {}, {}, folder
        words = shlex.split(line) if set(line) & set("\"'\\") else line.split()
        words = words[1:] if words[:1] == ["rupture"] else words
        if not words:
            raise UsageError("the command is empty: name a program")
        pairs = [word.partition("=")[::2] for word in words]
        pairs += zip(words, words[1:])
        self.outputs = [name for option, name in pairs if option in OUTPUTS and name]
        for name in self.outputs:
            if not PLAIN.fullmatch(name):
                raise UsageError(f"'{line}' writes '{name}': give the plain name of a file")
        self.program = words[0]
        self.words = [words[0], *map(self.plain, words[1:])]
        self.is_analysis, self.is_ours = words[0] == "analyze", words[0] in OURS
        self.line = shlex.join(self.words)
        super().__init__(digest_of_program(self.program, store), *self.words)

    def plain(self, word):
        if "@" in word:
            return TOKEN.sub(lambda found: self.named(found["name"], found.groups()), word)
        option, equals, value = word.partition("=") if word[:2] == "--" else ("", "", word)
        if value and value not in self.outputs and os.path.isfile(path := f"{self.folder}/{value}"):
            return option + equals + self.named(os.path.basename(value), os.path.realpath(path))
        return word

    def check_output(self, name):
        """Raises NoSuchName for a file that it does not write, as far as its words tell."""
        if self.is_ours and AT_TIME.sub("", name.removesuffix(".sum")) not in self.outputs:
            wrote = ", ".join(self.outputs) or "no files"
            raise NoSuchName(f"'{self.line}' writes {wrote}, not {name}")


class Measurement(Work):
    """A Python function of files, and of numbers and texts."""

    outputs, is_analysis, is_ours = (), True, None

    def __init__(self, function, files, folder, store):
        if "<" in function.__qualname__:
            raise UsageError(
                f"{function.__qualname__} has no name: measure with a function of a module"
            )
        self.inputs, self.stamps, self.function = {}, {}, function
        self.arguments = [self.argument(one, folder) for one in files]
        shown = [one.name if isinstance(one, Path) else repr(one) for one in self.arguments]
        self.line = " ".join([function.__qualname__, *shown])
        super().__init__("measured", digest_of_function(function, store), *map(repr, shown))

    def argument(self, one, folder):
        """A Path with the plain name of an input; anything else as it is."""
        if isinstance(one, Made):
            return Path(self.named(one.name, (one.command.own, one.name)))
        if isinstance(one, (str, Path)) and os.path.isfile(path := os.path.join(folder, one)):
            return Path(self.named(os.path.basename(path), os.path.realpath(path)))
        return one
