"""Does commands once: who owns which file, who reads it, and what is made again."""

import os
import re
import shutil
import threading
import time
from collections import Counter
from concurrent.futures import Future
from pathlib import Path

import json

from rupture.commands.code import RUNS, path_of
from rupture.commands.identity import Refused, Report
from rupture.errors import Failure, UsageError


class Unknown(SystemExit):
    """What nobody has run, and shall not run now."""


class Scope:
    """A point, or all of a call. What was named in it goes with it."""

    def __init__(self, parent=None, only_known=False):
        self.parent = parent
        self.named, self.read, self.asked = set(), [], []
        self.only_known = only_known or bool(parent and parent.only_known)
        self.is_cancelled = self.has_run = False

    def around(self):
        scope = self
        while scope:
            yield scope
            scope = scope.parent


class Making:
    def __init__(self, store, executor, pool, dry_run=False):
        self.store, self.executor, self.pool, self.dry_run = store, executor, pool, dry_run
        self.guard = threading.RLock()
        self.tasks = {}  # by id: commands that run
        self.commands = {}  # by id
        self.made = {}  # by id: folders with files, those read last at the end
        self.sizes = {}  # of these [bytes], but for what is kept
        self.cap = shutil.disk_usage(store.folder).free // 2
        self.owners, self.readers = Counter(), Counter()  # by id: open scopes; who reads now
        self.outermost = Scope()
        self.here = threading.local()

    @property
    def scope(self):
        return getattr(self.here, "scope", self.outermost)

    # --- names

    def name(self, command, keep=()):
        """The one command that this is; it belongs to the outermost open point that named it."""
        for name in keep:
            command.check_output(name)
        with self.guard:
            command = self.commands.setdefault(command.own, command)
            if not command.kept.issuperset(keep):
                command.kept.update(keep)
                self.keep(command)
            self.own(command)
            self.scope.asked.append(command)
        return command

    def own(self, command):
        if not any(command.own in scope.named for scope in self.scope.around()):
            self.scope.named.add(command.own)
            self.owners[command.own] += 1

    def open(self, command, name):
        """The path of a file for what is no command; the file stays as long as the point."""
        with self.guard:
            self.own(command)
            self.readers[command.own] += 1
            self.scope.read.append(command.own)
        path = self.file(command, name)
        if self.dry_run and not os.path.exists(path):
            raise Unknown(f"{command.line} has not been run")
        return path

    # --- what is there

    def report(self, command):
        return self.answer(self.store.result(command.own) or self.do(command))

    def answer(self, result):
        if result["status"] == "refused":
            raise Refused(result["sentence"])
        return result["report"]

    def file(self, command, name):
        """The path of a made file, which is made again if it is gone."""
        if not (path := self.found(command, name)):
            self.answer(self.do(command))
            path = self.found(command, name)
        if not path:
            raise Failure(f"'{command.line}' has not written {name}")
        return path

    def found(self, command, name):
        with self.guard:
            if folder := self.made.pop(command.own, None):
                self.made[command.own] = folder
                if self.dry_run or (folder / name).is_file():
                    return folder / name
        if result := self.store.result(command.own):
            self.answer(result)
            return self.store.kept(command.own, name, result)
        return None

    # --- doing it

    def do(self, command):
        """Its result. Two points may want the same; then one of them waits."""
        with self.guard:
            is_mine = command.own not in self.tasks
            task = self.tasks.setdefault(command.own, Future())
        if not is_mine:
            with self.pool.waits():
                return task.result()
        try:
            task.set_result(result := self.do_now(command))
            return result
        except BaseException as fault:
            task.set_exception(fault)
            raise
        finally:
            with self.guard:
                del self.tasks[command.own]

    def do_now(self, command):
        result = self.store.result(command.own)
        if result and (command.is_analysis or result["status"] == "refused"):
            return result  # somebody has just done it
        if self.scope.only_known:
            raise Unknown(f"{command.line} has not been run")
        read = Counter(source[0] for source in command.inputs.values() if isinstance(source, tuple))
        with self.guard:
            self.readers.update(read)
        try:
            paths = {
                plain: self.file(self.commands[source[0]], source[1])
                if isinstance(source, tuple)
                else source
                for plain, source in command.inputs.items()
            }
            if self.dry_run:
                return self.show(command)
            command.check_unchanged()
            if any(scope.is_cancelled for scope in self.scope.around()):
                raise Unknown("another point has failed")
            for scope in self.scope.around():
                scope.has_run = True
            return (
                self.compute(command, paths)
                if command.is_ours is not None
                else self.measure(command, paths)
            )
        finally:
            with self.guard:
                self.readers.subtract(read)
                for own in read:
                    self.drop(own)

    def show(self, command):
        with self.guard:
            print("rupture" if command.is_ours else "", command.line)
            if command.is_analysis:
                raise Unknown(f"{command.line} has not been run")
            self.made[command.own] = Path()
        return {"status": "done", "report": None}

    def measure(self, command, paths):
        since = time.monotonic()
        result = {"command": command.line, "status": "done"}
        arguments = (paths[str(one)] if isinstance(one, Path) else one for one in command.arguments)
        try:
            result["report"] = command.function(*arguments)
        except Failure as why:
            result |= {"status": "refused", "sentence": str(why)}
        return self.store.save(
            command.own, result | {"seconds": round(time.monotonic() - since, 2)}
        )

    def compute(self, command, paths):
        folder = self.store.now / command.own
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, path in paths.items():
            try:
                os.symlink(os.path.abspath(path), folder / name)
            except OSError:
                shutil.copyfile(path, folder / name)
        since = time.monotonic()
        # what nobody types
        said = (
            ["--json"]
            if command.is_analysis
            else ["--quiet", "--json"]
            if command.program in RUNS
            else []
        )
        said = [word for word in said if word not in command.words]
        ended = self.executor.start(
            [path_of(command.program), *command.words[1:], *said], folder
        ).result()
        result = {
            "command": command.line,
            "status": "done",
            "seconds": round(time.monotonic() - since, 2),
        }
        differs = command.is_analysis and ended.code == 1 and ended.output and not ended.sentence
        if ended.code and not differs:
            shutil.rmtree(folder, ignore_errors=True)
            sentence = ended.sentence
            if (
                command.is_ours
                and ended.code in (1, 2)
                and sentence
                and not sentence.startswith("Traceback")
            ):
                sentence = sentence.splitlines()[-1]
                return self.store.save(
                    command.own, result | {"status": "refused", "sentence": sentence}
                )
            raise Failure(f"'{command.line}' ended with {ended.code}: {sentence}")
        result["report"] = None
        if command.is_analysis:
            lines = [json.loads(line) for line in ended.output.splitlines()]
            result["report"] = lines if "--also" in command.words else lines[0]
        elif command.program in RUNS:
            files = json.loads(ended.output)["files"]
            result["checksums"] = {file["path"]: file["checksum"] for file in files}
        for name in paths:
            (folder / name).unlink()
        if command.is_analysis:
            shutil.rmtree(folder)
            return self.store.save(command.own, result)
        with self.guard:
            self.made[command.own] = folder
            result = self.keep(command, result)
            self.drop_some()
        return result

    # --- files that stay, and files that go

    def keep(self, command, result=None):
        """Puts files that are to stay into the store; `result`: of a command that has just run."""
        result = result or self.store.result(command.own)
        folder = self.made.get(command.own)
        if not result or not folder or self.dry_run:
            return result
        kept = {
            n: self.store.keep(command.own, n, folder / n)
            for n in sorted(command.kept)
            if (folder / n).is_file()
        }
        sizes = (path.stat().st_size for path in folder.iterdir() if path.name not in kept)
        self.sizes[command.own] = sum(sizes)
        return self.store.save(command.own, {**result, "kept": kept})

    def drop_some(self):
        """As much as there is beyond the cap, of what nobody reads now."""
        for own in list(self.made):
            if sum(self.sizes.values()) <= self.cap:
                break
            if self.readers[own] <= 0:
                self.remove(own)

    def drop(self, own):
        if self.readers[own] <= 0 and self.owners[own] <= 0:
            self.remove(own)

    def remove(self, own):
        self.sizes.pop(own, None)
        if (folder := self.made.pop(own, None)) and not self.dry_run:
            shutil.rmtree(folder, ignore_errors=True)

    # --- points

    def within(self, scope, function, *values):
        """Calls a function for a point."""
        before, self.here.scope = self.scope, scope
        try:
            return function(*values)
        finally:
            self.here.scope = before
            with self.guard:
                self.owners.subtract(scope.named)
                self.readers.subtract(scope.read)
                for own in {*scope.named, *scope.read}:
                    self.drop(own)
