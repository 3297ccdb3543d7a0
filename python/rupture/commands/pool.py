"""A pool of threads: as many work as there are cores. Whoever waits lets another one work."""

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
        self.free, self.resuming = cores - 1, 0  # one is the caller's
        self.threads, self.idle, self.most = 0, 0, 4 * cores + 60
        self.groups = []  # that have points nobody has begun, the innermost last
        self.stopped = False

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
            self.do(group, *job)
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
        """Finds threads for what can be begun; `changed` is held."""
        begun = min(self.free - self.resuming, sum(len(group.waiting) for group in self.groups))
        for _ in range(min(begun - self.idle, self.most - self.threads)):
            self.threads += 1
            self.idle += 1
            threading.Thread(target=self.work, daemon=True).start()
        self.changed.notify_all()

    def work(self):
        while True:
            with self.changed:
                self.changed.wait_for(self.is_needed)
                if self.stopped:
                    return
                self.free -= 1
                self.idle -= 1
                group = self.groups[-1]
                job = self.next_of(group)
            self.do(group, *job)
            with self.changed:
                self.free += 1
                self.idle += 1
                self.changed.notify_all()

    def is_needed(self):
        return self.stopped or self.groups and self.free > self.resuming

    def close(self):
        self.stopped = True
        with self.changed:
            self.changed.notify_all()

    def next_of(self, group):
        with self.changed:
            job = group.waiting.popleft() if group.waiting else None
            if job and not group.waiting:
                self.groups.remove(group)
        return job

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
            group.left -= len(group.waiting)
            if group.waiting:
                self.groups.remove(group)
                group.waiting.clear()
