"""Results on the disk: STORE/xx/ID.json of each command, and beside it ID.NAME of the files that
are kept. They appear whole or not at all, and are checked when they are read back. What is needed
for the moment is in STORE/now, which goes with the call that made it, or with the next one."""

import fcntl
import hashlib
import json
import os
import shutil
import sys
from contextlib import suppress
from pathlib import Path

from rupture.commands.identity import Report
from rupture.errors import Failure

MARKER = "rupture-store"  # says whose folder it is; who has locked it may write
LAYOUT = "A store of results of rupture, layout 1. It may be deleted as a whole.\n"


def complain(sentence):
    print(sentence, file=sys.stderr, flush=True)


def sha256_of(path):
    with open(os.open(path, os.O_RDONLY | os.O_NOFOLLOW), "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def sync(path):
    number = os.open(path, os.O_RDONLY | os.O_NOFOLLOW)
    try:
        os.fsync(number)
    finally:
        os.close(number)


def link_or_copy(source, path):
    try:
        os.link(source, path)
    except OSError:  # a file system without links
        shutil.copyfile(source, path)


class Store:
    """One call at a time may use it."""

    def __init__(self, folder):
        self.folder = Path(folder).absolute()
        self.now = self.folder / "now"
        self.fits = {}  # kept files that were checked, with their dates
        self.take()
        shutil.rmtree(self.now, ignore_errors=True)
        self.now.mkdir()

    def take(self):
        """Fails for a folder that is not ours, and if another call uses it."""
        self.folder.mkdir(parents=True, exist_ok=True)
        inside = list(os.scandir(self.folder))
        if inside and MARKER not in (one.name for one in inside):
            raise Failure(
                f"{self.folder} has files and is no store of rupture's: name another folder"
            )
        for one in inside:
            if one.is_symlink():
                raise Failure(f"{one.path} is a link, which is not followed: move it away")
        self.lock = open(self.folder / MARKER, "a+", encoding="utf-8")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            sentence = f"another call works with {self.folder}: wait until it has ended"
            raise Failure(sentence) from None
        except OSError as error:  # of some shared file systems
            complain(f"cannot lock {self.folder} ({error.strerror}): do not start a second call")
        self.lock.seek(0)
        if (found := self.lock.read()) not in ("", LAYOUT):
            raise Failure(
                f"{self.folder} has another layout ({found.strip()}): name another folder"
            )
        self.lock.truncate(0)
        self.lock.write(LAYOUT)
        self.lock.flush()

    def place(self, own, name):
        return self.folder / own[:2] / f"{own}.{name}"

    # --- reports

    def result(self, own):
        """What is known of a command; None if nothing is."""
        try:
            with open(os.open(self.place(own, "json"), os.O_RDONLY | os.O_NOFOLLOW), "rb") as file:
                text = file.read()
        except FileNotFoundError:
            return None
        head, body = text[:78], text[78:]  # {"digest": "...",
        if head[12:76] != hashlib.sha256(body).hexdigest().encode():
            complain(f"{self.place(own, 'json')} is not as it was written: done again")
            return None
        return json.loads(b"{" + body, object_hook=Report)

    def save(self, own, result):
        """Returns it as it is read back."""
        body = json.dumps(result)[1:].encode()
        text = b'{"digest": "%s",' % hashlib.sha256(body).hexdigest().encode() + body
        place = self.place(own, "json")
        part = self.now / place.name
        part.write_bytes(text)
        self.put(part, place)
        return json.loads(b"{" + body, object_hook=Report)

    def put(self, part, place):
        sync(part)
        place.parent.mkdir(exist_ok=True)
        os.replace(part, place)

    # --- kept files

    def keep(self, own, name, path):
        """Its SHA-256."""
        part = self.now / f"{own}.{name}"
        link_or_copy(path, part)
        self.put(part, self.place(own, name))
        return sha256_of(self.place(own, name))

    def kept(self, own, name, result):
        """The path of a kept file; None if there is none, or another one."""
        place = self.place(own, name)
        if name not in result.get("kept", {}) or not os.path.lexists(place):
            return None
        stat = os.lstat(place)
        date = stat.st_ino, stat.st_size, stat.st_mtime_ns, stat.st_ctime_ns
        if self.fits.get(place) != date:
            with suppress(OSError):
                if sha256_of(place) == result["kept"][name]:
                    self.fits[place] = date
        if self.fits.get(place) == date:
            return place
        complain(f"{place} is not as it was written: made again")
        return None
