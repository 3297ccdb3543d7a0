"""Points at work on as many cores as there are. Whoever waits lends its core to another."""

import threading
from collections import deque
from contextlib import contextmanager


class Stopped(BaseException):
    """What is going on is not needed any more."""


class Group:
    """The points of one `each`: those that nobody has begun, and results in their order."""

    def __init__(self, function, points):
        self.function, self.waiting = function, deque(enumerate(points))
        self.left, self.results = len(points), [None] * len(points)
        self.done, self.fault = threading.Event(), None


class Pool:
    """`free`: cores that nobody uses; `resuming`: threads that have waited and need one."""

    def __init__(self, cores):
        self.changed = threading.Condition()
        self.cores, self.free, self.resuming = cores, cores - 1, 0  # one is the caller's
        self.threads, self.spare = 0, 60
        self.groups = []  # that have points nobody has begun, the innermost last
        self.stopped = False

    def resize(self, cores):
        with self.changed:
            self.free += cores - self.cores
            self.cores = cores
            self.hire()

    def map(self, function, points):
        """The results for all points, in their order. Raises what one of them raised, when those
        that had begun have ended."""
        if not points:
            return []
        group = Group(function, points)
        with self.changed:
            self.groups.append(group)
            self.hire()
        while job := self.next_of(group):
            self.do(*job)
        if not group.done.is_set():
            with self.waits():
                group.done.wait()
        if group.fault:
            raise group.fault
        return group.results

    @contextmanager
    def waits(self):
        """Another thread may use the core of this one within."""
        with self.changed:
            self.free += 1
            self.hire()
        try:
            yield
        finally:
            with self.changed:
                self.resuming += 1
                self.changed.wait_for(lambda: self.free > 0 or self.stopped)
                self.resuming -= 1
                self.free -= 1

    def hire(self):
        """Starts threads for what can be begun; `changed` is held."""
        while (
            self.groups and self.free > self.resuming and self.threads < 4 * self.cores + self.spare
        ):
            self.free -= 1
            self.threads += 1
            job = self.next_of(self.groups[-1])
            threading.Thread(target=self.work, args=[job], daemon=True).start()
        self.changed.notify_all()

    def work(self, job):
        while job:
            self.do(*job)
            job = self.another()

    def another(self):
        """None if there is none, or somebody who has waited needs the core."""
        with self.changed:
            if self.groups and self.free >= self.resuming and not self.stopped:
                return self.next_of(self.groups[-1])
            self.free += 1
            self.threads -= 1
            self.changed.notify_all()
        return None

    def next_of(self, group):
        with self.changed:
            if not group.waiting:
                return None
            job = group.waiting.popleft()
            if not group.waiting:
                self.groups.remove(group)
        return group, *job

    def do(self, group, number, point):
        try:
            group.results[number] = group.function(point)
        except BaseException as fault:
            if self.stopped and threading.current_thread() is threading.main_thread():
                raise
            self.cancel(group, fault)
        with self.changed:
            group.left -= 1
            if not group.left:
                group.done.set()

    def cancel(self, group, fault):
        """Nobody begins the others; those that are stopped for it say nothing."""
        with self.changed:
            if not group.fault or isinstance(group.fault, Stopped):
                group.fault = fault
            if group.waiting:
                group.left -= len(group.waiting)
                group.waiting.clear()
                self.groups.remove(group)

    def close(self):
        self.stopped = True
        with self.changed:
            self.changed.notify_all()
