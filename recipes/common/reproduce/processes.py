"""Programs that ./reproduce.sh starts, of which nothing is to be left behind.

Each has a process group of its own. A signal to ./reproduce.sh is passed on to the group. A guard,
which outlives ./reproduce.sh, ends the group if ./reproduce.sh was killed, and holds the lock of
the folder until then. So the next call can wait for that.
"""

import fcntl
import os
import signal
import socket
import subprocess
import sys
import time

from reproduce.project import LOGS, ROOT, Failure, complain, say

LOCK = "build/.lock"
SIGNALS = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM)
WAIT_FOR_GUARD = 30.0  # [s]

# Reads the number of the group that runs, or an empty line. Its input ends with ./reproduce.sh.
GUARD = """\
while read -r line; do group=$line; done
[ -n "$group" ] || exit 0
kill -INT "-$group" 2>/dev/null
for _ in $(seq 100); do kill -0 "-$group" 2>/dev/null || exit 0; sleep 0.1; done
kill -KILL "-$group" 2>/dev/null
"""


def is_running(number):
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass  # it is another user's
    return True


def end_group(group, number):
    try:
        os.killpg(group, number)
    except ProcessLookupError:
        pass


def take_lock(lock):
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError as error:  # of some shared file systems
        complain(f"runs in this folder are not kept apart, as it has no locks ({error.strerror}).")
    return True


def open_lock():
    try:
        LOGS.mkdir(parents=True, exist_ok=True)
        return os.open(LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
    except OSError as error:
        raise Failure(f"{ROOT}/build cannot be written ({error.strerror}).") from None


def holder_of(lock):
    """Host and number of the ./reproduce.sh that has the lock, or had it last."""
    host, _, number = os.pread(lock, 300, 0).decode().partition(" ")
    return (host, int(number)) if number.isdecimal() else (socket.gethostname(), os.getpid())


class Processes:
    """Two runs in the same folder would overwrite each other's files, so only one has its turn."""

    def __init__(self):
        self.group = None
        self.is_starting = False
        self.received = None
        self.lock = open_lock()
        self.take_turn()
        self.guard = subprocess.Popen(
            ["sh", "-c", GUARD],
            stdin=subprocess.PIPE,
            start_new_session=True,
            pass_fds=[self.lock],
            text=True,
        )
        for number in SIGNALS:
            if signal.getsignal(number) != signal.SIG_IGN:  # nohup
                signal.signal(number, self.receive)
        if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:  # in the background of a script
            signal.signal(signal.SIGINT, lambda *_: None)  # but what is started must not ignore it

    def take_turn(self):
        if not take_lock(self.lock):
            self.wait_for_guard()
        os.ftruncate(self.lock, 0)
        os.pwrite(self.lock, f"{socket.gethostname()} {os.getpid()}".encode(), 0)

    def wait_for_guard(self):
        """If the run that had the lock was killed, its guard ends what is left."""
        host, holder = holder_of(self.lock)
        if host != socket.gethostname():
            raise Failure(f"another ./reproduce.sh is, or was, running in this folder on {host}.")
        if is_running(holder):
            raise Failure(
                "another ./reproduce.sh is running in this folder; wait until it is done."
            )
        say("Waiting for the end of what an earlier run, which was killed, has left behind ...")
        end = time.monotonic() + WAIT_FOR_GUARD
        while not take_lock(self.lock):
            if time.monotonic() > end:
                raise Failure(
                    "programs of an earlier run, which was killed, are still running here."
                )
            time.sleep(0.1)

    def receive(self, number, _):
        """The first signal lets programs save what they have; the next one ends them."""
        is_first = self.received is None
        self.received = self.received or number
        if self.is_starting:
            return  # run() will see it
        if self.group is None:
            sys.exit(128 + self.received)
        end_group(self.group, signal.SIGINT if is_first else signal.SIGKILL)

    def write_to_guard(self, text):
        print(text, file=self.guard.stdin, flush=True)

    def run(self, command, **options):
        """The exit code of a program. Processes that it has left running are ended with it."""
        self.is_starting = True
        with subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            start_new_session=True,
            pass_fds=[self.lock],
            **options,
        ) as process:
            self.group = process.pid
            self.write_to_guard(process.pid)
            self.is_starting = False
            if self.received:
                end_group(process.pid, signal.SIGINT)
            code = process.wait()
        if self.received:
            sys.exit(128 + self.received)  # and the guard looks after what is left
        if code:
            end_group(process.pid, signal.SIGINT)
        else:
            self.write_to_guard("")
        self.group = None
        return code
