"""What load and restart say of their progress, on a terminal and elsewhere."""

import contextlib
import fcntl
import os
import pty
import re
import struct
import subprocess
import termios
import time
from pathlib import Path

import pytest

from conftest import BIN, stopped

SMALL = "--set slider.Nx=9 --set slider.Nz=5 --set slider.H=0.07 --set driving.h=0.0175"
DONE = r" *(\d+) %"
TIME = r"t = 0\.\d{4} s of 0\.3000 s"
RATE = r" *[\d,]+ steps/s"
LEFT = r" *\d+(\.\d+)? (min|s) left"
LINE = f"{DONE}   {TIME}   {RATE}   {LEFT}"
LOAD = f"load {SMALL} --until 0.3"
pytestmark = pytest.mark.usefixtures("folder")


def start(line, stderr):
    tool, *words = line.split()
    return subprocess.Popen([BIN / tool, *words], stdout=subprocess.PIPE, stderr=stderr)


def all_of(terminal):
    """Everything that is written on it until its last writer has ended."""
    text = b""
    try:
        while data := os.read(terminal, 65536):
            text += data
    except OSError:  # so Linux says that there is nobody any more
        pass
    os.close(terminal)
    return text.decode()


def on_terminal(line, width):
    """Standard error of a command on a terminal of this width: the lines one after another."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
    process = start(line, theirs)
    os.close(theirs)
    text = all_of(ours)
    process.communicate()
    assert process.returncode == 0, text
    return text.split("\r")


@pytest.mark.parametrize("width", [100, 20])
def test_on_a_terminal_is_one_line_that_is_cut_where_it_ends(width):
    first, *lines, cleared, rest = on_terminal(f"{LOAD} -o a.h5", width)
    assert (first, cleared, rest) == ("", " " * (width - 1), "")
    assert lines
    for line in lines:
        assert re.fullmatch(LINE if width == 100 else f"{DONE}   t = .*", line.rstrip())
        assert len(line) == width - 1


def test_of_a_run_until_quiet_has_no_percentage():
    on_terminal(f"load {SMALL} -o a.h5", 80)
    _, *lines, _, _ = on_terminal("restart a.h5 -o b.h5 --until-quiet 0.3 --for 0.3", 80)
    for line in lines:
        assert re.fullmatch(rf"t = \d\.\d+ s of at most 0\.3000 s   {RATE}", line.rstrip())


def test_an_alarm_begins_a_line():
    on_terminal(f"load {SMALL} -o a.h5 --until 1e-4 --set driving.V=1", 80)
    changes = "--set slider.damping=0 --set driving.K=1.6e11"  # unstable
    lines = on_terminal(f"restart a.h5 -o b.h5 --for 3e-3 --on-alarm report {changes}", 80)
    alarm = next(n for n, line in enumerate(lines) if "alarm" in line)
    assert lines[alarm].startswith("restart: alarm: the energy account ")
    assert lines[alarm - 1] == " " * 79


def stopped_for(pause, *lines):
    """Standard error of runs that stand still for a while, all at the same time."""
    runs = [
        start(f"{line} -o {n}.h5 --checkpoint-at 1ms", subprocess.PIPE)
        for n, line in enumerate(lines)
    ]
    while len(list(Path().glob("?-t0.001000000.h5"))) < len(runs):
        time.sleep(0.01)
    with contextlib.ExitStack() as still:
        for run in runs:
            still.enter_context(stopped(run))
        time.sleep(pause)
    said = [run.communicate()[1].decode() for run in runs]
    assert not any(run.returncode for run in runs), said
    return said


def test_elsewhere_is_a_line_per_tenth_of_what_takes_long_unless_it_is_quiet():
    line, nothing = stopped_for(5, LOAD, f"{LOAD} --quiet")
    assert re.fullmatch(rf"load: {LINE}\n", line)
    assert [int(done) % 10 for done in re.findall(DONE, line)] == [0]
    assert nothing == ""
