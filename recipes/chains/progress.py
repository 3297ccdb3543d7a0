"""Says what Ninja does: a line for each point that is done, with x of y, the time so far and an
estimate for the rest; of a failure, the end of what was said."""

import re
import sys
import time
from collections import deque
from contextlib import suppress
from pathlib import Path

LOG = Path("build/log/recipes.log")
LAST_LINES = 30
STATUS = "[%f/%t] "  # of Ninja ($NINJA_STATUS)
WAIT = 10.0  # [s] before the time for the rest is estimated
STEP = re.compile(r"\[(\d+)/(\d+)\] (.*)")
FAILED = re.compile(r"FAILED: (\S+)")
UNSAID = ("ninja: no work to do.", "ninja: build stopped: ")


def log(text):
    LOG.parent.mkdir(parents=True, exist_ok=True)
    with LOG.open("a", encoding="utf-8") as file:
        print(time.strftime("%F %T"), text, file=file)


def show(text):
    """A reader who has gone, as of `| head`, or a full disk does not stop the run."""
    with suppress(OSError):
        print(text, flush=True)


def complain(text):
    log(text)
    print(text, file=sys.stderr, flush=True)


def follow(lines):
    """Returns whether Ninja did anything."""
    start, did, described = time.monotonic(), False, ""
    seconds = began = 0.0  # when the numbers that Ninja gives began [s]
    last = 0  # of these numbers; after what decides about other points, they begin anew
    said: deque[str] = deque(maxlen=LAST_LINES)  # of a program that failed
    for line in lines:
        if step := STEP.fullmatch(line):
            complain_all(said)
            count, total, described = step.groups()
            if int(count) <= last:
                began = seconds
            did, last, seconds = True, int(count), time.monotonic() - start
            if described.startswith("plan "):
                continue
            log(described)
            rest = rest_of(seconds - began, last, int(total))
            show(f"[{seconds:4.0f} s{rest}] {count:>{len(total)}}/{total} {described}")
        elif failed := FAILED.match(line):
            complain(f"\nFailed: {described}\n  to make: {failed[1]}")
            log(next(lines, ""))  # the command
            said.append("")
        elif line.startswith("ninja: "):
            complain_all(said)
            if not line.startswith(UNSAID):
                complain(line)
        elif said:
            said.append(f"  {line}")
        else:
            show(f"  {line}")
    complain_all(said)
    return did


def rest_of(seconds, count, total):
    """How long the rest takes if it takes as long as what is done, once that means something."""
    rest = seconds * (total - count) / count
    return f", about {rest:.0f} s left" if seconds > WAIT and rest >= 1 else ""


def complain_all(said):
    for text in filter(str.strip, said):
        complain(text)
    said.clear()
