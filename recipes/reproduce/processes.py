"""Starts programs for ./reproduce.sh, and leaves none of them running.

Each has a process group of its own. A signal to ./reproduce.sh is passed on to the group; if
./reproduce.sh was killed, the program gets one from the system. The programs hold its lock, too, so
the next call begins when they have ended."""

import fcntl
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

from rupture.errors import Failure
from rupture.replacing import ENDING
from reproduce.project import LOGS, ROOT, WORK, complain

LOCK = "build/.lock"
SET_UP = Path(__file__).with_name("set-up.sh")


def end_group(group, number):
    with suppress(ProcessLookupError):
        os.killpg(group, number)


def open_lock():
    try:
        LOGS.mkdir(parents=True, exist_ok=True)
        return os.open(LOCK, os.O_RDWR | os.O_CREAT, 0o666)
    except OSError as error:
        raise Failure(f"{ROOT}/build cannot be written ({error.strerror}).") from None


def take_lock(lock):
    """Fails for a lock that `clean` has deleted meanwhile, because the next run takes another."""
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError as error:  # of some shared file systems
        complain(f"cannot lock this folder ({error.strerror}): do not start a second run in it.")
    return os.path.exists(LOCK) and os.path.samefile(LOCK, lock)


class Processes:
    """Two runs in one folder would overwrite each other's files, so only one at a time may run."""

    def __init__(self):
        self.group = None
        self.is_starting = False
        self.received = None
        self.ending = signal.SIGINT  # the signal that the group then gets
        self.lock = open_lock()  # it ends with this process, and with programs, which inherit it
        self.has_turn = take_lock(self.lock)
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

    def run(self, command):
        """Runs a program and returns its exit code. Of a program that fails, processes that it
        leaves running are ended."""
        self.is_starting = True
        process = subprocess.Popen(
            ["setpriv", "--pdeathsig", "INT", *map(str, command)],  # gets a signal if we are killed
            stdin=subprocess.DEVNULL,
            start_new_session=True,
            pass_fds=[self.lock],
        )
        self.group, self.is_starting = process.pid, False
        if self.received:
            end_group(process.pid, self.ending)
        code = process.wait()
        self.group = None
        if self.received:
            complain("interrupted; results that were finished before are kept")
            sys.exit(128 + self.received)
        if code:
            end_group(process.pid, signal.SIGINT)
        return code


def set_up(processes, *words):
    """Runs set-up.sh for packages and programs. If it fails, it has printed the reason."""
    if code := processes.run(["bash", SET_UP, *words]):
        sys.exit(code)


def ensure_packages(processes, *purposes):
    """Installs what is missing. An installed rupture has its packages."""
    if not WORK:
        set_up(processes, "packages", *purposes)
