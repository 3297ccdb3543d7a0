"""Runs Ninja, and says what it does: python -m chains.progress LOG NINJA WORD...

A line for each point and figure that is done, with x of y and the time so far; everything about a
failure. Exit code 0; Ninja's own if it failed; 3 if there was nothing to do."""

import os
import re
import signal
import subprocess
import sys
import time
from collections import deque
from contextlib import suppress

from runs.written import append_to

NOTHING_TO_DO = 3
STEP = re.compile(r"\[(\d+)/(\d+)\] (.*)\n")
FAILED = re.compile(r"FAILED: (\S+)")
UNSAID = ("ninja: no work to do.", "ninja: build stopped: ")
LAST_LINES = 30  # of what a program that failed has said


def show(text, stream):
    """A reader who has gone, as of `| head`, or a full disk does not stop the run."""
    try:
        print(text, file=stream, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def follow(lines, log):
    """Returns whether Ninja did anything."""
    start, did, described = time.monotonic(), False, ""
    said: deque[str] = deque(maxlen=LAST_LINES)  # of a program that failed
    for line in lines:
        with suppress(OSError):
            log.write(f"{time.strftime('%F %T')} {line}")
        if step := STEP.fullmatch(line):
            show_last(said)
            count, total, described = step.groups()
            did, seconds = True, time.monotonic() - start
            if not described.startswith("plan "):
                show(f"[{seconds:4.0f} s] {count:>{len(total)}}/{total} {described}", sys.stdout)
        elif failed := FAILED.match(line):
            show(f"\nFailed: {described}\n  to make: {failed[1]}", sys.stderr)
            next(lines, "")  # Ninja repeats the command
            said.append("")
        elif line.startswith("ninja: "):
            show_last(said)
            if not line.startswith(UNSAID):
                show(line.rstrip(), sys.stderr)
        elif said:
            said.append(f"  {line.rstrip()}")
        else:
            show(f"  {line.rstrip()}", sys.stdout)
    show_last(said)
    return did


def show_last(said):
    """What a program that failed has said last."""
    for text in said:
        if text:
            show(text, sys.stderr)
    said.clear()


def main(log, *command):
    signal.signal(signal.SIGINT, lambda *_: None)  # Ninja gets it, too, and ends first
    os.environ["NINJA_STATUS"] = "[%f/%t] "
    with append_to(log) as file, subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as ninja:
        did = follow(ninja.stdout, file)
    return ninja.returncode or (0 if did else NOTHING_TO_DO)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
