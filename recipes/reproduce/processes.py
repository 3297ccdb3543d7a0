"""Starts programs for ./reproduce.sh, and leaves none of them running.

Each has a process group of its own. A signal to ./reproduce.sh is passed on to the group. A guard,
which outlives ./reproduce.sh, ends the group if ./reproduce.sh was killed. The programs hold a lock
of their own, so the next call can wait for their end.
"""

import fcntl
import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

from rupture.errors import Failure
from rupture.replacing import ENDING
from reproduce.project import LOGS, ROOT, WORK, complain, say

SET_UP = Path(__file__).with_name("set-up.sh")
WAIT = 30.0  # [s] for programs of a run that was killed

# Its input is a line when the group $0 has ended well, and ends with ./reproduce.sh.
GUARD = """\
read -r _ && exit
kill -INT "-$0" 2>/dev/null
for _ in $(seq 100); do kill -0 "-$0" 2>/dev/null || exit 0; sleep 0.1; done
kill -KILL "-$0" 2>/dev/null
"""


def end_group(group, number):
    with suppress(ProcessLookupError):
        os.killpg(group, number)


def open_lock(name):
    try:
        LOGS.mkdir(parents=True, exist_ok=True)
        return os.open(f"build/.{name}", os.O_RDWR | os.O_CREAT, 0o666)
    except OSError as error:
        raise Failure(f"{ROOT}/build cannot be written ({error.strerror}).") from None


def take_lock(lock, name):
    """Fails for a lock that `clean` has deleted meanwhile, because the next run takes another."""
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError as error:  # of some shared file systems
        complain(f"cannot lock this folder ({error.strerror}): do not start a second run in it.")
    path = f"build/.{name}"
    return os.path.exists(path) and os.path.samefile(path, lock)


def wait_for(lock, name):
    if take_lock(lock, name):
        return
    say("Waiting for programs of an earlier run, which was killed, to end ...")
    end = time.monotonic() + WAIT
    while not take_lock(lock, name):
        if time.monotonic() > end:
            raise Failure("programs of an earlier run, which was killed, are still running here.")
        time.sleep(0.1)


class Processes:
    """Two runs in one folder would overwrite each other's files, so only one at a time may run."""

    def __init__(self):
        self.group = None
        self.is_starting = False
        self.received = None
        self.ending = signal.SIGINT  # the signal that the group then gets
        self.turn = open_lock("lock")  # it ends with this process
        self.has_turn = take_lock(self.turn, "lock")
        self.lock = open_lock("lock-of-programs")  # they inherit it
        if self.has_turn:
            wait_for(self.lock, "lock-of-programs")
        for number in ENDING:
            if signal.getsignal(number) != signal.SIG_IGN:  # nohup
                signal.signal(number, self.receive)
        if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # in the background of a script
            signal.signal(signal.SIGINT, lambda *_: None)  # but what is started must not ignore it

    def receive(self, number, _):
        """The first signal lets programs save what they have; the next one ends them."""
        self.ending = signal.SIGKILL if self.received else signal.SIGINT
        self.received = self.received or number
        if self.group:
            end_group(self.group, self.ending)
        elif not self.is_starting:  # else run() will see it
            sys.exit(128 + self.received)

    def start(self, command, stdin):
        return subprocess.Popen(command, stdin=stdin, start_new_session=True, pass_fds=[self.lock])

    def run(self, command):
        """Runs a program and returns its exit code. Processes that it leaves running are ended."""
        self.is_starting = True
        process = self.start(command, subprocess.DEVNULL)
        guard = self.start(["sh", "-c", GUARD, str(process.pid)], subprocess.PIPE)
        self.group, self.is_starting = process.pid, False
        if self.received:
            end_group(process.pid, self.ending)
        code = process.wait()
        self.group = None
        if self.received:
            complain("interrupted; results that were finished before are kept")
            sys.exit(128 + self.received)  # and the guard looks after what is left
        guard.communicate(b"" if code else b"\n")
        return code


# --- packages and programs, by set-up.sh ----------------------------------------------------


def set_up(processes, *words):
    """If the script fails, it has printed the reason."""
    if code := processes.run(["bash", SET_UP, *map(str, words)]):
        sys.exit(code)


def ensure_packages(processes, *purposes):
    """Installs what is missing. An installed rupture has its packages."""
    if not WORK:
        set_up(processes, "packages", *purposes)


def build(processes, cores, target, *purposes):
    """Builds a target. Packages for these purposes are installed in the meantime."""
    set_up(processes, "build", cores, target, *purposes)
