"""Results on the disk: STORE/xx/ID.json of each command, and beside it ID.NAME of each file that is
kept. They appear whole or not at all, and are checked when they are read. STORE/now has the files
of the call that runs, and goes with it, or with the next one if it was killed."""

import hashlib
import json
import math
import os
import re
import shutil
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import get_ident

from rupture.commands.code import stamp_of
from rupture.commands.folder import Marker, complain, fits, open_own, parsed, read_own, sha256_of
from rupture.commands.identity import PLAIN
from rupture.errors import MachineFailure

MARKER = Marker("rupture-store", "Results of rupture, layout 1. All of it may be deleted.\n")
BODY = len('{"digest": "",') + 64  # where the rest of a result begins


def is_moment(value):
    """Seconds since 1970, or between two moments."""
    return isinstance(value, (int, float)) and 0 <= value < 1e11


COMMON = {"command": str, "build": str | None, "code?": int}
COMMON |= {"started": is_moment, "seconds": is_moment}
REFUSED = COMMON | {"status": re.compile("refused"), "sentence": str}
REPORTED = COMMON | {"status": re.compile("done"), "report": object}


def have_plain_names(value):
    """Whether each text is that of a file in the folder of its command."""
    return fits(value, {"": str}) and all(map(PLAIN.fullmatch, value))


MADE = COMMON | {"status": re.compile("done"), "checksums?": have_plain_names}
MADE |= {"kept": have_plain_names}


class Report(dict):
    """A dict of which `report.slow.speed` is report["slow"]["speed"]."""

    def __getattr__(self, name):
        if name in self:
            return self[name]
        raise AttributeError(f"there is no {name} in the report; it has {', '.join(self)}")


@contextmanager
def writing(path):
    """Says what could not be written."""
    try:
        yield
    except OSError as error:
        sentence = f"cannot write {path}: {error.strerror}; what is done is kept"
        raise MachineFailure(sentence) from error


def head(own, body):
    """How the file of a result begins."""
    found = hashlib.sha256(own.encode() + body).hexdigest()
    return f'{{"digest": "{found}",'.encode()


def has_reported(value):
    """The result of `analyze`, or of a measurement."""
    return fits(value, REFUSED) or fits(value, REPORTED)


def has_made(value):
    """The result of a command that writes files."""
    return fits(value, REFUSED) or fits(value, MADE)


def is_result(value):
    """Of any command."""
    return has_reported(value) or has_made(value)


def as_read(body, form=dict):
    return parsed(b"{" + body, form, object_hook=Report)


class Store:
    """One call at a time may use it."""

    def __init__(self, folder):
        self.folder = Path(folder).absolute()
        self.now = self.folder / "now"
        self.checked = {}  # {kept file: its stamp when it was found to be as it was written}
        with writing(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
            MARKER.check(self.folder)
            self.lock = MARKER.lock(self.folder)
            if self.now.exists() and not self.now.is_dir():  # rmtree() would wait for a pipe
                self.now.unlink()
            shutil.rmtree(self.now, ignore_errors=True)
            self.now.mkdir(exist_ok=True)

    def close(self):
        shutil.rmtree(self.now, ignore_errors=True)
        self.lock.close()

    def place(self, own, name):
        return self.folder / place_of(own, name)

    def refuse(self, place, sentence):
        """What is not as it was written goes."""
        complain(f"{place} is not as it was written: {sentence}")
        with suppress(OSError):
            place.unlink()

    def result(self, own, form=is_result):
        """What is known of a command, or what else has an ID; None if nothing is."""
        place = self.place(own, "json")
        with suppress(OSError, ValueError):  # a link, a pipe
            text = read_own(place)
            if text[:BODY] == head(own, text[BODY:]):
                return as_read(text[BODY:], form)
        return self.refuse(place, "it is done again") if os.path.lexists(place) else None

    def save(self, own, result):
        """Returns it as it will be read."""
        body = json.dumps(result)[1:].encode()
        place = self.place(own, "json")
        with writing(place):
            part = self.now / f"{get_ident()}-{place.name}"  # two threads may read one module
            part.write_bytes(head(own, body) + body)
            self.put(part, place)
        return as_read(body)

    def put(self, part, place):
        with open_own(part) as file:
            os.fsync(file.fileno())
        place.parent.mkdir(exist_ok=True)
        os.replace(part, place)

    def keep(self, own, path):
        """Returns its SHA-256."""
        place = self.place(own, path.name)
        with writing(place):
            part = self.now / place.name
            link_or_copy(path, part)
            self.put(part, place)
        self.checked[place] = stamp_of(place)
        return sha256_of(place, math.inf)

    def kept(self, own, name, result):
        """The path of a kept file; None if there is none, or another one."""
        place = self.place(own, name)
        if name not in result.get("kept", {}) or not os.path.lexists(place):
            return None
        stamp = stamp_of(place)
        if self.checked.get(place) != stamp:
            with suppress(OSError):
                if sha256_of(place, math.inf) == result["kept"][name]:
                    self.checked[place] = stamp
        if self.checked.get(place) == stamp:
            return place
        return self.refuse(place, "it is made again")


class Onlooker(Store):
    """The store of a dry run: it writes nothing, and may look while a call works."""

    def __init__(self, folder):
        self.folder = Path(folder).absolute()
        self.now, self.checked = self.folder / "now", {}
        if self.folder.is_dir():
            MARKER.check(self.folder)

    def save(self, own, result):
        return as_read(json.dumps(result)[1:].encode())

    def refuse(self, place, sentence):
        complain(f"{place} is not as it was written: {sentence}")

    def close(self):
        pass


def place_of(own, name):
    """The place of a file in the folder of a store."""
    return f"{own[:2]}/{own}.{name}"


def link_or_copy(source, path, link=os.link):
    try:
        link(source, path)
    except OSError:  # a file system without links
        shutil.copyfile(source, path)
