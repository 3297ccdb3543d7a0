"""Says how many points are done, and estimates the rest from the seconds of last time."""

import threading
import time
from collections import Counter

from rupture.commands.code import digest
from rupture.commands.folder import complain

PAUSE = 1.0  # [s] at least between two lines
SHOWN = 5  # sentences


class Progress:
    """Points that only look results up say nothing, and count for nothing."""

    def __init__(self, title, points, store):
        self.title, self.store, self.guard = title, store, threading.Lock()
        self.own = digest("seconds", title)
        self.keys = [digest(repr(point)) for point in points]
        last = store.result(self.own, {"": float | int}) if title else None
        self.seconds = last or {}  # of last time
        usual = sum(self.seconds.values()) / max(1, len(self.seconds)) or 1.0
        self.expected = [self.seconds.get(key, usual) for key in self.keys]
        self.rest, self.worked, self.done = sum(self.expected), 0.0, 0
        self.since = self.shown = time.monotonic()

    def add(self, number, seconds, has_run):
        with self.guard:
            self.done += 1
            self.rest -= self.expected[number]
            if not has_run or not self.title:
                return
            self.worked += self.expected[number]
            self.seconds[self.keys[number]] = round(seconds, 2)
            now, is_last = time.monotonic(), self.done == len(self.keys)
            if is_last or now - self.shown > PAUSE:
                self.shown, passed = now, now - self.since
                left = f", about {passed * self.rest / self.worked:.0f} s left" * (not is_last)
                complain(f"[{passed:4.0f} s{left}] {self.title}: {self.done} of {len(self.keys)}")

    def end(self, refused):
        """`refused`: sentences of points that ended with one."""
        if self.worked:
            self.store.save(self.own, self.seconds)
            for sentence, count in Counter(refused).most_common(SHOWN):
                complain(f"  {self.title}: {count} of {len(self.keys)} refused: {sentence}")
