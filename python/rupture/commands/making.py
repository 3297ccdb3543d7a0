"""Does commands once, and again those whose files are gone."""

import os
import shutil
import threading
import time

from rupture.commands.code import digest_of_program, path_of, stamp_of
from rupture.commands.holdings import Holdings, Scope
from rupture.commands.identity import Made, Refused
from rupture.commands.pool import Stopped
from rupture.commands.store import complain, writing
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


class Making:
    def __init__(self, store, executor, pool, dry_run, cap):
        self.store, self.executor, self.pool, self.dry_run = store, executor, pool, dry_run
        self.holdings, self.locks = Holdings(store, cap), {}
        self.here, self.outermost = threading.local(), Scope()
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
            self.holdings.leave(scope)

    def stop(self):
        """Takes no lock: signals call it."""
        self.pool.stopped = True
        self.executor.stop()

    # --- what is there

    def report(self, work):
        self.scope.asked.append(work)
        result = self.store.result(work.own) or self.do(work)
        return self.answer(result)["report"] if result else Untold()

    def answer(self, result):
        if result.get("status") == "refused":
            raise Refused(result["sentence"])
        return result

    def open(self, made):
        """The path of a file that somebody else than a command reads. It stays with the point."""
        self.holdings.name(made.work, self.scope)
        self.holdings.read([made.work.own])
        self.scope.read.append(made.work.own)
        self.scope.asked.append(made.work)
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
        if path := self.holdings.found(made):
            return path
        result = self.store.result(made.work.own)
        return result and self.store.kept(made.work.own, made.name, self.answer(result))

    # --- doing it

    def do(self, work):
        """Returns the result of a work. One does it; others who want it wait."""
        if self.scope.only_known:
            self.check_sources(work)
            raise Unknown(work.own)
        lock = self.locks.setdefault(work.own, threading.Lock())
        if not lock.acquire(blocking=False):
            with self.pool.waits():
                lock.acquire()
        try:
            result = self.store.result(work.own) or {}
            is_report = result and (work.has_report or result["status"] == "refused")
            if is_report or work.own in self.holdings.folders:  # somebody has just done it
                return result
            return self.do_now(work, result)
        finally:
            lock.release()

    def check_sources(self, work):
        """Raises Refused if it is known that one of its files cannot be made."""
        for source in work.inputs.values():
            if isinstance(source, Made):
                if result := self.store.result(source.work.own):
                    self.answer(result)
                else:
                    self.check_sources(source.work)

    def do_now(self, work, before):
        sources = work.inputs.items()
        needed = [source.work.own for _, source in sources if isinstance(source, Made)]
        self.holdings.read(needed)
        try:
            paths = {n: self.path(s) if isinstance(s, Made) else s for n, s in sources}
            if self.dry_run:
                return self.show(work)
            scopes = [*self.scope.and_around()]
            if self.pool.stopped or any(scope.is_cancelled for scope in scopes):
                raise Stopped
            work.check_unchanged()
            for scope in scopes:
                scope.has_run = True
            return self.compute(work, paths, before)
        finally:
            self.holdings.let_go(self.holdings.readers, needed)

    def show(self, work):
        if work.own not in self.holdings.folders:
            print(work.typed, flush=True)
        self.holdings.folders[work.own] = self.store.now
        return {}

    def compute(self, work, paths, before):
        folder, since = self.store.now / work.own, time.monotonic()
        try:
            with writing(folder):
                folder.mkdir()
                for name, path in paths.items():
                    put_input(path, folder / name)
            result = {"command": work.line, "build": work.build(), "started": int(time.time())}
            result |= work.done_in(folder, self.executor)
            result["seconds"] = round(time.monotonic() - since, 3)
            is_made = not work.has_report and result["status"] == "done"
            if is_made:
                for name in paths:
                    (folder / name).unlink()
                result["kept"] = self.holdings.stored(work, folder, before)
            result = self.store.save(work.own, result)
        except BaseException as fault:
            shutil.rmtree(folder, ignore_errors=True)
            if self.pool.stopped and isinstance(fault, Failure):
                raise Stopped from None
            raise
        if is_made:
            self.holdings.add(work, folder, result["kept"])
        else:
            shutil.rmtree(folder, ignore_errors=True)
        if before.get("checksums") != result.get("checksums") and before:
            complain(f"'{work.line}' has not written what it wrote before")
        return result


def put_input(path, place):
    try:
        os.symlink(path, place)
    except OSError:  # a file system without links
        shutil.copyfile(path, place)
