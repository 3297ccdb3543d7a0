"""Runs Ninja, and says what it does: python -m chains.progress LOG NINJA WORD...

A line for each point and figure that is done, with x of y and the time so far; everything about a
failure. Exit code 0; Ninja's own if it failed; 3 if there was nothing to do."""

import os
import re
import signal
import subprocess
import sys
import time
from contextlib import suppress

from runs.written import append_to

NOTHING_TO_DO = 3
STEP = re.compile(r"\[(\d+)/(\d+)\] (.*)\n")
FAILED = re.compile(r"FAILED: (\S+)")
UNSAID = ("ninja: no work to do.", "ninja: build stopped: subcommand failed.")


def show(text, stream):
    """A reader who has gone, as of `| head`, or a full disk does not stop the run."""
    try:
        print(text, file=stream, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def follow(lines, log):
    """Returns whether Ninja did anything."""
    start, did, is_command, is_of_failed = time.monotonic(), False, False, False
    for line in lines:
        with suppress(OSError):
            log.write(f"{time.strftime('%F %T')} {line}")
        if is_command:  # Ninja repeats it behind FAILED
            is_command = False
        elif step := STEP.fullmatch(line):
            did, is_of_failed = True, False
            count, total, what = step.groups()
            described = what
            if not what.startswith("plan "):
                seconds = time.monotonic() - start
                show(f"[{seconds:4.0f} s] {count:>{len(total)}}/{total} {what}", sys.stdout)
        elif failed := FAILED.match(line):
            show(f"\nFailed: {described}\n  to make: {failed[1]}", sys.stderr)
            is_command = is_of_failed = True
        elif line.strip() not in UNSAID:
            show(f"  {line.rstrip()}", sys.stderr if is_of_failed else sys.stdout)
    return did


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
