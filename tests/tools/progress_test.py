"""What load and restart say of their progress, on a terminal and elsewhere."""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import tempfile
import termios
import time
import unittest
from pathlib import Path

from conftest import BIN

SMALL = "--set slider.Nx=9 --set slider.Nz=5 --set slider.H=0.07 --set driving.h=0.0175"
DONE = r" *(\d+) %"
TIME = r"t = 0\.\d{4} s of 0\.3000 s"
RATE = r" *[\d,]+ steps/s"
LEFT = r" *\d+(\.\d+)? (min|s) left"


def set_width(terminal, width):
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))


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


class Progress(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def command(self, line):
        tool, *words = line.split()
        return [BIN / tool, *words]

    def on_terminal(self, line, width):
        """Standard error of a command on a terminal of this width: the lines one after another."""
        ours, theirs = pty.openpty()
        set_width(theirs, width)
        process = subprocess.Popen(
            self.command(line), cwd=self.folder, stdout=subprocess.PIPE, stderr=theirs
        )
        os.close(theirs)
        text = all_of(ours)
        process.communicate()
        self.assertEqual(process.returncode, 0, text)
        return text.split("\r")

    def loaded(self, width):
        return self.on_terminal(f"load {SMALL} --until 0.3 -o a.h5 --force", width)

    def test_on_a_terminal_is_one_line_that_fits(self):
        shown = {
            100: f"{DONE}   {TIME}   {RATE}   {LEFT}",
            50: f"{DONE}   {TIME}   {LEFT}",
            24: f"{DONE}   {LEFT}",
            10: DONE,
            4: r" *\d+( %?)?",
        }
        for width, form in shown.items():
            with self.subTest(width=width):
                first, *lines, cleared, rest = self.loaded(width)
                self.assertEqual((first, rest), ("", ""))
                self.assertEqual(cleared, " " * (width - 1))
                self.assertGreater(len(lines), 0)
                for line in lines:
                    self.assertRegex(line.rstrip(), f"^{form}$")
                    self.assertEqual(len(line), width - 1)
                done = [int(line.strip().split(" ")[0]) for line in lines]
                self.assertEqual(done, sorted(done))
                self.assertLess(done[-1], 100)

    def test_follows_the_terminal_when_that_changes(self):
        ours, theirs = pty.openpty()
        set_width(theirs, 100)
        line = f"load {SMALL} --until 0.3 -o a.h5"
        process = subprocess.Popen(
            self.command(line), cwd=self.folder, stdout=subprocess.PIPE, stderr=theirs
        )
        os.close(theirs)
        os.read(ours, 1)
        set_width(ours, 30)
        *_, cleared, rest = all_of(ours).split("\r")
        process.communicate()
        self.assertEqual((cleared, rest), (" " * 29, ""))

    def test_of_a_run_until_quiet_has_no_percentage(self):
        self.on_terminal(f"load {SMALL} -o a.h5", 80)
        _, *lines, _, _ = self.on_terminal("restart a.h5 -o b.h5 --until-quiet 0.3 --for 0.3", 80)
        for line in lines:
            self.assertRegex(line.rstrip(), rf"^t = \d\.\d+ s of at most 0\.3000 s   {RATE}$")

    def test_quiet_runs_show_nothing(self):
        self.assertEqual(self.on_terminal(f"load {SMALL} --until 0.1 -o a.h5 --quiet", 80), [""])

    def test_an_alarm_begins_a_line(self):
        self.on_terminal(f"load {SMALL} -o a.h5 --until 1e-4 --set driving.V=1", 80)
        changes = "--set slider.damping=0 --set driving.K=1.6e11"  # unstable
        lines = self.on_terminal(f"restart a.h5 -o b.h5 --for 3e-3 --on-alarm report {changes}", 80)
        alarm = next(n for n, line in enumerate(lines) if "alarm" in line)
        self.assertTrue(lines[alarm].startswith("restart: alarm: the energy account "))
        self.assertEqual(lines[alarm - 1], " " * 79)

    def stopped_for(self, pause, line):
        """Standard error of a run that stands still for a while, once it has begun."""
        process = subprocess.Popen(
            self.command(line + " --checkpoint-at 1ms"),
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        while not (self.folder / "a-t0.001000000.h5").exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGSTOP)
        time.sleep(pause)
        process.send_signal(signal.SIGCONT)
        _, err = process.communicate()
        self.assertEqual(process.returncode, 0, err)
        return err

    def test_elsewhere_is_a_line_per_tenth_of_what_takes_long(self):
        err = self.stopped_for(5, f"load {SMALL} --until 0.3 -o a.h5")
        self.assertRegex(err, rf"^load: {DONE}   {TIME}   {RATE}   {LEFT}\n$")
        self.assertEqual([int(done) % 10 for done in re.findall(DONE, err)], [0])

    def test_elsewhere_short_and_quiet_runs_print_nothing(self):
        for quiet in "", " --quiet":
            with self.subTest(quiet=quiet):
                pause = 5 if quiet else 0
                line = f"load {SMALL} --until 0.1 -o a.h5 --force" + quiet
                self.assertEqual(self.stopped_for(pause, line), "")


if __name__ == "__main__":
    unittest.main()
