"""What a command is: its words, what its program computes with, and what its input files are."""

import json
import os
import re
import shlex
from functools import cached_property
from pathlib import Path
from threading import Lock

from rupture.commands.code import OURS, WRITERS, build_at, digest, digest_at
from rupture.commands.code import digest_of_function, stamp_of
from rupture.errors import Failure, MachineFailure, NoSuchName, UsageError, is_of_machine

TOKEN = re.compile(r"@([0-9a-f]{16})/([\w.+-]+)")  # a made file in a command
OUTPUTS = ("-o", "--output", "--record")
PLAIN = re.compile(r"\w[\w.+-]*")
AT_TIME = re.compile(r"-t\d+\.\d{9}(?=\.\w+$)")  # of a checkpoint during a run
SAID = {
    "analyze": ["--json"],
    **dict.fromkeys(WRITERS, ["--quiet", "--json"]),
}  # which nobody types


class Refused(Failure):
    """Why a program cannot do what a command asks for."""


class Made(os.PathLike):
    """A file that a command writes. Opening it makes it, if need be."""

    def __init__(self, work, name):
        self.work, self.name = work, name

    def __str__(self):
        return f"@{self.work.own}/{self.name}"

    def __fspath__(self):
        return str(self.work.making.open(self))


class Work:
    """Something to be done once. `line`: how one types it; `own`: what it is known by; `inputs`:
    {plain name: a Made, or the path of a user's own file}; `owners`: how many open points have
    named it; `readers`: how many need its files now."""

    outputs: list[str] = []
    has_report = True

    def __init__(self, making, folder):
        self.making, self.folder = making, folder
        self.inputs, self.kept, self.stamps = {}, set(), {}
        self.owners = self.readers = 0
        self.lock = Lock()  # of who does it

    def sources(self):
        """Those whose files it reads."""
        return [source.work for source in self.inputs.values() if isinstance(source, Made)]

    def known_by(self, *parts):
        sources = (f"{name}={self.content(source)}" for name, source in self.inputs.items())
        return digest(*parts, *sources)

    def content(self, source):
        if isinstance(source, Made):
            return str(source)
        self.stamps[source] = stamp_of(source)
        return digest_at(source, self.stamps[source])

    def check_unchanged(self):
        for path, stamp in self.stamps.items():
            if stamp_of(path) != stamp:
                raise Failure(f"{path} has changed meanwhile: start again")

    def own_file(self, name):
        """The path of a user's file, relative to the recipe or script; None if there is none."""
        path = os.path.join(self.folder, name)
        return os.path.realpath(path) if os.path.isfile(path) else None

    def build(self):
        """Which programs of ours do it; None for others."""
        return None

    def named(self, name, source):
        """The plain name of an input, numbered if it is taken. It is no option."""
        name = name if PLAIN.match(name) else f"_{name}"
        stem, dot, ending = name.rpartition(".")
        names = (f"{stem}-{n}{dot}{ending}" if n > 1 else name for n in range(1, 999))
        free = (one for one in names if one not in self.outputs)
        found = next(one for one in free if str(self.inputs.get(one, source)) == str(source))
        self.inputs[found] = source
        return found


def words_in(line):
    """The words of a command, without `rupture`."""
    words = shlex.split(line) if set(line) & set("\"'\\") else line.split()
    words = words[1:] if words[:1] == ["rupture"] else words
    if not words:
        raise UsageError("the command is empty: begin it with the name of a program")
    return words


def outputs_in(words):
    pairs = [*zip(words, words[1:]), *(word.partition("=")[::2] for word in words)]
    return [name for option, name in pairs if option in OUTPUTS and name]


class Command(Work):
    """A program with its words; command["end.h5"] is a file that it writes."""

    def __init__(self, line, making, folder):
        """`line`: as one types it; or its words, which are taken as they are, and files."""
        super().__init__(making, folder)
        self.is_typed = isinstance(line, str)
        words = words_in(line) if self.is_typed else line
        self.outputs = outputs_in([word for word in words if isinstance(word, str)])
        for name in self.outputs:
            if not PLAIN.fullmatch(name):
                raise UsageError(f"'{line}' writes '{name}': give a name without a folder")
        self.program, self.has_report = words[0], words[0] == "analyze"
        self.words = [words[0], *map(self.plain, words[1:])]
        self.path, stamp, known_by = making.program(self.program)
        self.stamps[self.path] = stamp
        self.own = self.known_by(known_by, *self.words)

    @cached_property
    def line(self):
        return shlex.join(self.words)

    @property
    def typed(self):
        return f"rupture {self.line}" if self.program in OURS else self.line

    def plain(self, word):
        """A word as it is typed in the folder of the command."""
        if isinstance(word, Made):
            return self.named(word.name, word)
        if self.is_typed and "@" in word:
            return TOKEN.sub(lambda found: self.input_of(*found.groups()), word)
        option, equals, value = word.partition("=") if word.startswith("--") else ("", "", word)
        if value and value not in self.outputs and (path := self.own_file(value)):
            return option + equals + self.named(os.path.basename(value), path)
        return word

    def input_of(self, own, name):
        if own not in self.making.works:
            raise UsageError(f"@{own}/{name} is a file of another call: make it in this one")
        return self.named(name, Made(self.making.works[own], name))

    def __getitem__(self, name):
        """Raises NoSuchName for a file that it does not write, as far as its words tell."""
        if self.program in OURS and AT_TIME.sub("", name) not in self.outputs:
            wrote = ", ".join(self.outputs) or "no files"
            raise NoSuchName(f"'{self.line}' writes {wrote}, not {name}")
        return Made(self, name)

    def build(self):
        return build_at(self.path, stamp_of(self.path))

    def done_in(self, folder, executor):
        """The result in a folder with its inputs. Raises Failure if there is none."""
        said = SAID.get(self.program, [])
        words = [self.path, *self.words[1:], *(w for w in said if w not in self.words)]
        try:
            code, output, sentence = executor.run(words, folder)
        except OSError as error:
            raise MachineFailure(f"'{self.line}' cannot run: {error}") from error
        if code and not (code == 1 and self.has_report and output and not sentence):  # as of diff
            last = "".join(sentence.splitlines()[-1:])
            if code in (1, 2) and last.removeprefix("rupture ").startswith(f"{self.program}: "):
                return {"status": "refused", "code": code, "sentence": last}
            kind = MachineFailure if code == 3 else Failure
            raise kind(f"'{self.line}' ended with {code}: {sentence}; the next call tries again")
        answers = [json.loads(line) for line in output.splitlines()] if said else []
        if self.has_report:
            report = answers if len(answers) > 1 else answers[0]
            return {"status": "done", "code": code, "report": report}
        files = answers[0]["files"] if said else []
        checksums = {file["path"]: file["checksum"] for file in files}
        return {"status": "done", "code": code, "checksums": checksums}


class Measurement(Work):
    """A Python function of files, numbers and texts."""

    def __init__(self, function, arguments, making, folder):
        super().__init__(making, folder)
        code = getattr(function, "__code__", None)
        if not code or "<" in function.__qualname__ or not os.path.isfile(code.co_filename):
            raise UsageError(f"{function} is no function in a file: define it in one by name")
        self.function = function
        self.arguments = [self.plain(one) for one in arguments]
        shown = [one.name if isinstance(one, Path) else json.dumps(one) for one in self.arguments]
        self.line = " ".join([function.__qualname__, *shown])
        self.typed = f"# in Python: {function.__module__}.{self.line}"
        self.own = self.known_by(digest_of_function(function, making.store), *shown)

    def plain(self, one):
        """A Path with the plain name of an input; anything else as it is."""
        if isinstance(one, Made):
            return Path(self.named(one.name, one))
        if isinstance(one, (str, Path)) and (path := self.own_file(one)):
            return Path(self.named(os.path.basename(one), path))
        return one

    def done_in(self, folder, _):
        arguments = (folder / one if isinstance(one, Path) else one for one in self.arguments)
        try:
            return {"status": "done", "report": self.function(*arguments)}
        except Failure as why:
            if is_of_machine(why):
                raise
            return {"status": "refused", "sentence": str(why).replace(f"{folder}/", "")}
