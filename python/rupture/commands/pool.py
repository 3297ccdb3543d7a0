"""As many threads at work as there are cores. Whoever waits lets another one work."""

import threading
from collections import deque
from contextlib import contextmanager


class Group:
    """Points of one `each`: those that nobody has begun, and results in their order."""

    def __init__(self, function, points):
        self.function = function
        self.waiting = deque(enumerate(points))
        self.results = [None] * len(points)
        self.left = len(points)
        self.done = threading.Event()
        self.fault = None


class Pool:
    def __init__(self, cores):
        self.changed = threading.Condition()
        self.free = cores - 1  # one has the caller
        self.resuming = 0  # threads that waited, and have something to go on with
        self.idle = self.threads = 0
        self.most = 4 * cores + 60  # threads
        self.groups = []  # that have points nobody has begun; the innermost last
        self.stopped = False

    def map(self, function, points):
        """The results for all points, in their order. Raises what one of them raised; then those
        that nobody has begun are left out."""
        group = Group(function, points)
        if not points:
            return []
        with self.changed:
            self.groups.append(group)
            self.hire()
        while (job := self.next_of(group)) is not None:
            self.do(group, *job)
        with self.waits():
            group.done.wait()
        if group.fault:
            raise group.fault
        return group.results

    @contextmanager
    def waits(self):
        """Another thread may use this one's core within."""
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
        """Makes threads for what can be done now; `changed` is held."""
        room = min(self.free - self.resuming, sum(len(group.waiting) for group in self.groups))
        for _ in range(min(room - self.idle, self.most - self.threads)):
            self.threads, self.idle = self.threads + 1, self.idle + 1
            threading.Thread(target=self.work, daemon=True).start()
        self.changed.notify_all()

    def work(self):
        while not self.stopped:
            with self.changed:
                self.changed.wait_for(lambda: self.groups and self.free > self.resuming)
                self.idle -= 1
                self.free -= 1
                group = self.groups[-1]
                job = self.next_of(group)
            self.do(group, *job)
            with self.changed:
                self.free, self.idle = self.free + 1, self.idle + 1
                self.changed.notify_all()

    def next_of(self, group):
        with self.changed:
            if not group.waiting:
                return None
            job = group.waiting.popleft()
            if not group.waiting:
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
        with self.changed:
            group.fault = group.fault or fault
            group.left -= len(group.waiting)
            if group.waiting:
                self.groups.remove(group)
                group.waiting.clear()
