"""Files of commands while a call needs them: who owns them, who reads them, which stay."""

import shutil
import threading
from collections import Counter
from contextlib import suppress

from rupture.errors import Failure


class Scope:
    """A point, or all of a call. What was named in it goes with it."""

    def __init__(self, parent=None, only_known=False):
        self.parent = parent
        self.named, self.read, self.asked = set(), [], []
        self.only_known = only_known or bool(parent and parent.only_known)
        self.lacks: set = set()  # ids of what is not known
        self.is_cancelled = self.has_run = False

    def and_around(self):
        scope = self
        while scope:
            yield scope
            scope = scope.parent


class Holdings:
    """What is held. By ids of commands, `folders` with their files, those used last at the end;
    `owners`: how many open points have named them; `readers`: who needs their files now."""

    def __init__(self, store, cap):
        self.store = store
        self.cap = cap or shutil.disk_usage(store.folder).free // 2  # [bytes]
        self.guard = threading.RLock()
        self.works, self.folders, self.sizes = {}, {}, {}
        self.owners: Counter[str] = Counter()
        self.readers: Counter[str] = Counter()

    def name(self, work, scope):
        """The one of its kind, which the outermost open point that named it owns."""
        with self.guard:
            first = self.works.setdefault(work.own, work)
            first.kept |= work.kept
            if not any(work.own in one.named for one in scope.and_around()):
                scope.named.add(work.own)
                self.owners[work.own] += 1
        return first

    def read(self, owns):
        with self.guard:
            self.readers.update(owns)

    def found(self, made):
        """The path of a file that is there; None if none is."""
        own = made.work.own
        with self.guard:
            if folder := self.folders.pop(own, None):
                self.folders[own] = folder
                if folder == self.store.now or (folder / made.name).is_file():
                    return folder / made.name
        return None

    def add(self, work, folder, kept):
        others = (path for path in folder.iterdir() if path.name not in kept)
        with self.guard:
            self.folders[work.own] = folder
            self.sizes[work.own] = sum(path.stat().st_size for path in others)
            self.limit()

    def limit(self):
        """Lets go what is beyond the cap, of what nobody reads now."""
        unread = (own for own in list(self.folders) if self.readers[own] <= 0)
        while sum(self.sizes.values()) > self.cap and (own := next(unread, None)):
            self.remove(own)

    def keep(self, made):
        with self.guard:
            made.work.kept.add(made.name)

    def stored(self, work, folder, before):
        """{name: SHA-256} of the files that stay; new ones are put into the store."""
        old = before.get("kept", {})
        kept = {name: sha for name, sha in old.items() if self.store.kept(work.own, name, before)}
        new = (name for name in sorted(work.kept - kept.keys()) if (folder / name).is_file())
        return kept | {name: self.store.keep(work.own, folder / name) for name in new}

    def let_go(self, counter, owns):
        with self.guard:
            counter.subtract(owns)
            for own in {*owns}:
                if self.readers[own] <= 0 and self.owners[own] <= 0:
                    self.remove(own)
            self.limit()

    def remove(self, own):
        """Files that do not stay."""
        if self.sizes.pop(own, None) is None:
            return
        folder, work, result = self.folders.pop(own), self.works[own], self.store.result(own)
        if result and work.kept - result["kept"].keys():  # asked for after it was done
            self.store.save(own, result | {"kept": self.stored(work, folder, result)})
        shutil.rmtree(folder, ignore_errors=True)

    def leave(self, scope):
        self.let_go(self.readers, scope.read)
        self.let_go(self.owners, scope.named)

    def close(self, scope):
        with suppress(Failure):
            self.leave(scope)
        self.store.close()
