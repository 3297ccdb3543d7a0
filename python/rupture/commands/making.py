"""Does commands once, and again those whose files are gone. Keeps files as long as a point that has
named their command is open, or somebody reads them."""

import os
import shutil
import threading
import time
from contextlib import contextmanager, suppress

from rupture.commands.code import digest_of_program, path_of, stamp_of
from rupture.commands.folder import complain
from rupture.commands.identity import Made, Refused
from rupture.commands.pool import Stopped
from rupture.commands.store import has_made, has_reported, link_or_copy, writing
from rupture.errors import Failure


class Unknown(SystemExit):
    """Raised for what nobody has run, and what shall not run now."""


class Untold:
    """The report of what nobody has done, in a dry run: who needs a value of it gets no further."""

    def unknown(self, *_):
        raise Unknown

    __getattr__ = __getitem__ = __iter__ = __len__ = __bool__ = __contains__ = unknown
    __str__ = __format__ = __float__ = __int__ = __array__ = __eq__ = __lt__ = __gt__ = unknown
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __neg__ = unknown
    __le__ = __ge__ = __rtruediv__ = __abs__ = __round__ = unknown
    __hash__ = object.__hash__


class Scope:
    """A point, or all of a call. The files of what was named in it go with it."""

    def __init__(self, parent=None, only_known=False):
        self.parent = parent
        self.named, self.read, self.asked = set(), [], []  # commands and measurements
        self.only_known = only_known or bool(parent and parent.only_known)
        self.lacks: set = set()  # ids of what is not known
        self.is_cancelled = self.has_run = False

    def and_around(self):
        scope = self
        while scope:
            yield scope
            scope = scope.parent


class Making:
    """`works`: by their ids; `held`: {one whose files are there: bytes that are not kept}, in the
    order of their use."""

    def __init__(self, store, executor, pool, dry_run, cap):
        self.store, self.executor, self.pool, self.dry_run = store, executor, pool, dry_run
        self.cap = cap or shutil.disk_usage(store.folder).free // 2  # [bytes]
        self.works, self.held, self.guard = {}, {}, threading.RLock()
        self.here, self.outermost, self.shown = threading.local(), Scope(), set()
        self.paths, self.programs = {}, {}

    @property
    def scope(self):
        return getattr(self.here, "scope", self.outermost)

    def program(self, name):
        """Its path, the stamp of that, and what it computes with."""
        path = self.paths[name] = self.paths.get(name) or path_of(name)
        if (stamp := stamp_of(path)) not in self.programs:
            self.programs[stamp] = path, stamp, digest_of_program(name, self.store)
        return self.programs[stamp]

    def within(self, scope, function, values):
        """Calls a function for a point."""
        before, self.here.scope = self.scope, scope
        try:
            return function(*values)
        finally:
            self.here.scope = before
            self.let_go(scope.named, scope.read)

    def name(self, work):
        """The one of its kind, which the outermost open point that named it owns."""
        with self.guard:
            first = self.works.setdefault(work.own, work)
            first.kept |= work.kept
            if not any(first in one.named for one in self.scope.and_around()):
                self.scope.named.add(first)
                first.owners += 1
        return first

    def stop(self):
        """Signals call it."""
        self.pool.stopped = True
        self.executor.stop()

    def close(self):
        self.stop()
        self.pool.close()
        self.executor.close()
        with suppress(Failure):
            self.let_go(self.outermost.named, self.outermost.read)
        self.store.close()

    # --- what is there

    def known(self, work):
        """Its result; None if nobody has done it."""
        return self.store.result(work.own, has_reported if work.has_report else has_made)

    def report(self, work):
        self.scope.asked.append(work)
        result = self.known(work) or self.do(work)
        return self.answer(result)["report"] if result else Untold()

    def answer(self, result):
        if result.get("status") == "refused":
            raise Refused(result["sentence"])
        return result

    def open(self, made):
        """The path of a file that somebody else than a command reads. It stays with the point."""
        work = self.name(made.work)
        with self.guard:
            work.readers += 1
        self.scope.read.append(work)
        self.scope.asked.append(work)
        path = self.path(made)
        if not os.path.exists(path):  # with --dry-run
            raise Unknown
        return path

    def path(self, made):
        """The path of a file, which is made again if it is gone."""
        if not (path := self.found(made)):
            self.answer(self.do(made.work))
            path = self.found(made)
        if not path:
            raise Failure(f"'{made.work.line}' has not written {made.name}")
        return path

    def found(self, made):
        work, path = made.work, self.store.now / made.work.own / made.name
        with self.guard:
            if work in self.held:
                self.held[work] = self.held.pop(work)
                if self.dry_run or path.is_file():
                    return path
        result = self.known(work)
        return result and self.store.kept(work.own, made.name, self.answer(result))

    # --- doing it

    def do(self, work):
        """Returns the result of a work. One does it; others who want it wait."""
        if self.scope.only_known:
            self.check_sources(work)
            for scope in self.scope.and_around():
                scope.lacks.add(work.own)
            raise Unknown
        if not work.lock.acquire(blocking=False):
            with self.pool.waits():
                work.lock.acquire()
        try:
            result = self.known(work) or {}
            is_report = result and (work.has_report or result["status"] == "refused")
            if is_report or work in self.held:  # somebody has just done it
                return result
            with self.reading(work.sources()):
                return self.do_now(work, result)
        finally:
            work.lock.release()

    def check_sources(self, work):
        """Raises Refused if it is known that one of its files cannot be made."""
        for source in work.sources():
            if result := self.known(source):
                self.answer(result)
            else:
                self.check_sources(source)

    def do_now(self, work, before):
        sources = work.inputs.items()
        paths = {n: self.path(s) if isinstance(s, Made) else s for n, s in sources}
        if self.dry_run:
            self.held[work] = 0
            self.show(work.typed, work)
            return {}
        scopes = [*self.scope.and_around()]
        if self.pool.stopped or any(scope.is_cancelled for scope in scopes):
            raise Stopped
        work.check_unchanged()
        for scope in scopes:
            scope.has_run = True
        folder = self.store.now / work.own
        try:
            result = self.compute(work, paths, folder, before)
        except BaseException as fault:
            if self.pool.stopped and isinstance(fault, Failure):
                raise Stopped from None
            raise
        finally:
            if work not in self.held:
                shutil.rmtree(folder, ignore_errors=True)
        if before and before.get("checksums") != result.get("checksums"):
            complain(f"'{work.line}' has not written what it wrote before")
        return result

    def show(self, line, key=None):
        """Prints it, once."""
        if (key or line) not in self.shown:
            self.shown.add(key or line)
            print(line, flush=True)

    def compute(self, work, paths, folder, before):
        since = time.monotonic()
        with writing(folder):
            folder.mkdir()
            for name, path in paths.items():
                link_or_copy(path, folder / name, os.symlink)
        result = {"command": work.line, "build": work.build(), "started": int(time.time())}
        result |= work.done_in(folder, self.executor)
        result["seconds"] = round(time.monotonic() - since, 3)
        if work.has_report or result["status"] == "refused":
            return self.store.save(work.own, result)
        for name in paths:
            (folder / name).unlink()
        result["kept"] = self.stored(work, before)
        result = self.store.save(work.own, result)
        others = (path for path in folder.iterdir() if path.name not in result["kept"])
        with self.guard:
            self.held[work] = sum(path.stat().st_size for path in others)
            self.limit()
        return result

    # --- files

    def stored(self, work, before):
        """{name: SHA-256} of the files that stay; new ones are put into the store."""
        old, folder = before.get("kept", {}), self.store.now / work.own
        kept = {name: sha for name, sha in old.items() if self.store.kept(work.own, name, before)}
        new = (name for name in sorted(work.kept - kept.keys()) if (folder / name).is_file())
        return kept | {name: self.store.keep(work.own, folder / name) for name in new}

    @contextmanager
    def reading(self, works):
        """Their files stay within, once they are there."""
        with self.guard:
            for work in works:
                work.readers += 1
        try:
            yield
        finally:
            self.let_go((), works)

    def let_go(self, named, read):
        """The files go of what nobody needs any more."""
        with self.guard:
            for work in named:
                work.owners -= 1
            for work in read:
                work.readers -= 1
            for work in {*named, *read}:
                if not work.owners and not work.readers:
                    self.remove(work)
            self.limit()

    def limit(self):
        """Lets go what is beyond the cap, of what nobody reads now."""
        for work in [one for one in self.held if not one.readers]:
            if sum(self.held.values()) > self.cap:
                self.remove(work)

    def remove(self, work):
        """Files that do not stay."""
        if self.held.pop(work, None) is None or self.dry_run:
            return
        result = self.known(work)
        if result and work.kept - result["kept"].keys():  # asked for after it was done
            self.store.save(work.own, result | {"kept": self.stored(work, result)})
        shutil.rmtree(self.store.now / work.own, ignore_errors=True)
