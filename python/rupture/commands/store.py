"""Results on the disk: STORE/xx/ID.json of each command, and beside it ID.NAME of each file that is
kept. They appear whole or not at all, and are checked when they are read. STORE/now has the files
of the call that runs, and goes with it, or with the next one if it was killed."""

import fcntl
import hashlib
import json
import os
import shutil
import sys
from contextlib import contextmanager, suppress
from pathlib import Path

from rupture.commands.code import stamp_of
from rupture.errors import Failure, MachineFailure

MARKER = "rupture-store"  # says whose folder it is, and of which layout; is locked
LAYOUT = "Results of rupture, layout 1. All of it may be deleted.\n"
BODY = len('{"digest": "",') + 64  # where the rest of a result begins


class Report(dict):
    """A dict of which `report.slow.speed` is report["slow"]["speed"]."""

    def __getattr__(self, name):
        if name in self:
            return self[name]
        raise AttributeError(f"there is no {name} in the report; it has {', '.join(self)}")


def complain(sentence):
    print(sentence, file=sys.stderr, flush=True)


@contextmanager
def writing(path):
    """Says what could not be written."""
    try:
        yield
    except OSError as error:
        sentence = f"cannot write {path}: {error.strerror}; what is done is kept"
        raise MachineFailure(sentence) from error


def open_own(path):
    """A file that is no link."""
    return open(os.open(path, os.O_RDONLY | os.O_NOFOLLOW), "rb")


def head(own, body):
    """How the file of a result begins."""
    found = hashlib.sha256(own.encode() + body).hexdigest()
    return f'{{"digest": "{found}",'.encode()


def as_read(body):
    return json.loads(b"{" + body, object_hook=Report)


def is_store(folder):
    """Whether it is ours, of this layout."""
    marker = Path(folder, MARKER)
    is_file = marker.is_file() and not marker.is_symlink()
    return is_file and marker.read_text(encoding="utf-8", errors="replace") == LAYOUT


class Store:
    """One call at a time may use it."""

    def __init__(self, folder):
        self.folder = Path(folder).absolute()
        self.now = self.folder / "now"
        self.checked = {}  # {kept file: its stamp when it was found to be as it was written}
        with writing(self.folder):
            self.folder.mkdir(parents=True, exist_ok=True)
            self.check()
            self.lock = self.take()
            shutil.rmtree(self.now, ignore_errors=True)
            self.now.mkdir(exist_ok=True)

    def check(self):
        """Raises Failure for a folder that is not ours."""
        inside = {one.name: one for one in os.scandir(self.folder)}
        if inside and MARKER not in inside:
            raise Failure(f"{self.folder} has other files: name a new folder for the store")
        for one in inside.values():
            if one.is_symlink():
                raise Failure(f"{one.path} is a link, which is not followed: move it away")

    def take(self):
        lock = open(self.folder / MARKER, "a+", encoding="utf-8")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Failure(f"another call uses {self.folder}: wait until it has ended") from None
        except OSError as error:  # of some shared file systems
            complain(f"cannot lock {self.folder} ({error.strerror}): do not start a second call")
        lock.seek(0)
        if (found := lock.read()) not in ("", LAYOUT):
            raise Failure(f"{self.folder} is of another version ({found.strip()}): name a new one")
        lock.write(LAYOUT.removeprefix(found))
        lock.flush()
        return lock

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

    def result(self, own):
        """What is known of a command; None if nothing is."""
        place = self.place(own, "json")
        try:
            with open_own(place) as file:
                text = file.read()
        except FileNotFoundError:
            return None
        except OSError:  # a link
            text = b""
        if text[:BODY] == head(own, text[BODY:]):
            return as_read(text[BODY:])
        return self.refuse(place, "it is done again")

    def save(self, own, result):
        """Returns it as it will be read."""
        body = json.dumps(result)[1:].encode()
        place = self.place(own, "json")
        with writing(place):
            part = self.now / place.name
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
        return self.sha256(place)

    def sha256(self, path):
        with open_own(path) as file:
            return hashlib.file_digest(file, "sha256").hexdigest()

    def kept(self, own, name, result):
        """The path of a kept file; None if there is none, or another one."""
        place = self.place(own, name)
        if name not in result.get("kept", {}) or not os.path.lexists(place):
            return None
        stamp = stamp_of(place)
        if self.checked.get(place) != stamp:
            with suppress(OSError):
                if self.sha256(place) == result["kept"][name]:
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
            self.check()

    def save(self, own, result):
        return as_read(json.dumps(result)[1:].encode())

    def refuse(self, place, sentence):
        complain(f"{place} is not as it was written: {sentence}")

    def close(self):
        pass


def place_of(own, name):
    """The place of a file in the folder of a store."""
    return f"{own[:2]}/{own}.{name}"


def link_or_copy(source, path):
    try:
        os.link(source, path)
    except OSError:  # a file system without links
        shutil.copyfile(source, path)
