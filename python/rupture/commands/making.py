"""Does commands once: who owns their files, who reads them, and which are made again."""

import os
import shutil
import threading
import time
from collections import Counter
from concurrent.futures import Future
from contextlib import contextmanager
from pathlib import Path

from rupture.commands.identity import Made, Refused
from rupture.commands.pool import Stopped
from rupture.commands.store import complain, writing
from rupture.errors import Failure


class Unknown(SystemExit):
    """What nobody has run, and shall not run now."""


class Scope:
    """A point, or all of a call. What was named in it goes with it."""

    def __init__(self, parent=None, only_known=False):
        self.parent = parent
        self.named, self.read, self.asked = set(), [], []
        self.only_known = only_known or bool(parent and parent.only_known)
        self.is_cancelled = self.has_run = False

    def and_around(self):
        scope = self
        while scope:
            yield scope
            scope = scope.parent


class Making:
    """`made`: folders of commands with their files, those used last at the end; `owners`, `readers`:
    how many points have named a command, and who reads its files now. All by ids of commands."""

    def __init__(self, store, executor, pool, dry_run, cap):
        self.store, self.executor, self.pool, self.dry_run = store, executor, pool, dry_run
        self.cap = cap or shutil.disk_usage(store.folder).free // 2  # [bytes], for files in `made`
        self.guard, self.here = threading.RLock(), threading.local()
        self.works, self.tasks, self.made, self.sizes = {}, {}, {}, {}
        self.owners, self.readers = Counter(), Counter()
        self.outermost = Scope()

    @property
    def scope(self):
        return getattr(self.here, "scope", self.outermost)

    def name(self, work, keep=()):
        """The one of its kind; it belongs to the outermost open point that named it."""
        for name in keep:
            work[name]  # raises NoSuchName
        with self.guard:
            work = self.works.setdefault(work.own, work)
            work.kept |= {*keep}
            if keep and (folder := self.made.get(work.own)) and not self.dry_run:
                self.keep(work, folder, self.store.result(work.own) or {})
            self.own(work)
        return work

    def own(self, work):
        if not any(work.own in scope.named for scope in self.scope.and_around()):
            self.scope.named.add(work.own)
            self.owners[work.own] += 1

    # --- what is there

    def report(self, work):
        self.scope.asked.append(work)
        return self.answer(self.store.result(work.own) or self.do(work))["report"]

    def open(self, made):
        """The path of a file for others than commands. It stays until the point ends."""
        with self.guard:
            self.own(made.work)
            self.readers[made.work.own] += 1
            self.scope.read.append(made.work.own)
            self.scope.asked.append(made.work)
        path = self.path(made)
        if self.dry_run and not os.path.exists(path):
            raise Unknown
        return path

    def path(self, made):
        """Of a file, which is made again if it is gone."""
        if not (path := self.found(made)):
            self.answer(self.do(made.work))
            path = self.found(made)
        if not path:
            raise Failure(f"'{made.work.line}' has not written {made.name}")
        return path

    def found(self, made):
        own = made.work.own
        with self.guard:
            if folder := self.made.pop(own, None):
                self.made[own] = folder
                if self.dry_run or (folder / made.name).is_file():
                    return folder / made.name
        result = self.store.result(own)
        return result and self.store.kept(own, made.name, self.answer(result))

    def answer(self, result):
        if result["status"] == "refused":
            raise Refused(result["sentence"])
        return result

    # --- doing it

    def do(self, work):
        """Its result. If somebody else does it, this waits."""
        if self.scope.only_known:
            for made in work.inputs.values():
                if isinstance(made, Made):
                    self.path(made)  # may have been refused
            raise Unknown
        with self.guard:
            if not (task := self.tasks.get(work.own)):
                mine = self.tasks[work.own] = Future()
        if task:
            try:
                with self.pool.waits():
                    return task.result()
            except Stopped:  # with the point of the other one
                self.check_needed()
                return self.do(work)
        try:
            mine.set_result(self.do_now(work))
        except BaseException as fault:
            mine.set_exception(fault)
        with self.guard:
            del self.tasks[work.own]
        return mine.result()

    def check_needed(self):
        if self.pool.stopped or any(scope.is_cancelled for scope in self.scope.and_around()):
            raise Stopped

    def do_now(self, work):
        result = self.store.result(work.own) or {}
        if result and (work.has_report or result["status"] == "refused" or work.own in self.made):
            return result  # somebody has just done it
        with self.reading(
            [made.work.own for made in work.inputs.values() if isinstance(made, Made)]
        ):
            paths = {
                name: self.path(source) if isinstance(source, Made) else source
                for name, source in work.inputs.items()
            }
            if self.dry_run:
                return self.show(work)
            self.check_needed()
            work.check_unchanged()
            for scope in self.scope.and_around():
                scope.has_run = True
            return self.compute(work, paths, result)

    @contextmanager
    def reading(self, owns):
        with self.guard:
            self.readers.update(owns)
        try:
            yield
        finally:
            self.let_go(self.readers, owns)

    def show(self, work):
        print(work.typed, flush=True)
        if work.has_report:
            raise Unknown
        self.made[work.own] = Path()
        return {"status": "done"}

    def compute(self, work, paths, before):
        folder = self.store.now / work.own
        since = time.monotonic()
        try:
            with writing(folder):
                folder.mkdir()
                for name, path in paths.items():
                    put_input(path, folder / name)
            result = {"command": work.line} | work.done_in(folder, self.executor)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            self.check_needed()
            raise
        result["seconds"] = round(time.monotonic() - since, 3)
        if work.has_report or result["status"] == "refused":
            shutil.rmtree(folder, ignore_errors=True)
            return self.store.save(work.own, result)
        for name in paths:
            (folder / name).unlink()
        if before.get("checksums", result["checksums"]) != result["checksums"]:
            complain(f"'{work.line}' has other results than before: {folder}")
        result = self.keep(work, folder, result | {"kept": before.get("kept", {})})
        with self.guard:
            self.made[work.own] = folder
            if work.kept - result["kept"].keys():  # somebody has just asked for it
                result = self.keep(work, folder, result)
            self.drop_some()
        return result

    # --- files that stay, and files that go

    def keep(self, work, folder, result):
        """Puts files that are to stay into the store."""
        kept = {n: sha for n, sha in result["kept"].items() if self.store.kept(work.own, n, result)}
        for path in sorted(folder.iterdir()):
            if path.name in work.kept and path.name not in kept:
                kept[path.name] = self.store.keep(work.own, path)
        others = (path for path in folder.iterdir() if path.name not in kept)
        self.sizes[work.own] = sum(path.stat().st_size for path in others)
        return self.store.save(work.own, result | {"kept": kept})

    def drop_some(self):
        """As much as is beyond the cap, of what nobody reads now."""
        for own in list(self.made):
            if sum(self.sizes.values()) > self.cap and self.readers[own] <= 0:
                self.remove(own)

    def let_go(self, counter, owns):
        with self.guard:
            counter.subtract(owns)
            for own in {*owns}:
                if self.readers[own] <= 0 and self.owners[own] <= 0:
                    self.remove(own)

    def remove(self, own):
        self.sizes.pop(own, None)
        if (folder := self.made.pop(own, None)) and not self.dry_run:
            shutil.rmtree(folder, ignore_errors=True)

    # --- points

    def within(self, scope, function, values):
        """Calls a function for a point."""
        before, self.here.scope = self.scope, scope
        try:
            return function(*values)
        finally:
            self.here.scope = before
            self.let_go(self.readers, scope.read)
            self.let_go(self.owners, scope.named)


def put_input(path, place):
    try:
        os.symlink(path, place)
    except OSError:  # a file system without links
        shutil.copyfile(path, place)
