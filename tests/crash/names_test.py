"""A run whose files are named like words of a command is interrupted, and resumed as it says."""

import re
import shlex
import signal
import subprocess
import time
import unittest

from scenario import BIN, INPUTS, Folder, without_notes

NAMES = ("x --resume.h5", "a -- b.h5", "restart --until 1.h5", "it's.h5")
SECONDS = 60  # until the first checkpoint must be there


def command(name, *more):
    """A run that takes some seconds and leaves its first checkpoint early."""
    return [
        *(
            str(BIN / "load"),
            "--config",
            "driven.ini",
            "--until",
            "0.4",
            "--checkpoint-every",
            "2e-3",
        ),
        *(
            "--set",
            "driving.V=0.01",
            "-o",
            name,
            "--record",
            f"of {name}",
            "--record-every",
            "1e-3",
        ),
        *more,
    ]


def run(words, folder):
    return subprocess.run(words, cwd=folder.path, capture_output=True, text=True, timeout=120)


class Names(unittest.TestCase):
    def interrupt(self, words, folder):
        """Sends SIGINT once there is a checkpoint; returns what the program said at its end."""
        pipe = subprocess.PIPE
        process = subprocess.Popen(words, cwd=folder.path, stdout=pipe, stderr=pipe, text=True)
        until = time.monotonic() + SECONDS
        while not any(re.search(r"-t0\.\d{9}\.h5$", name) for name in folder.files()):
            self.assertLess(time.monotonic(), until, "no checkpoint came")
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, -signal.SIGINT, out + err)
        return out, err

    def test_the_command_that_is_told_goes_on_and_the_run_is_complete(self):
        with Folder(INPUTS) as folder:
            self.assertEqual(run(command("whole.h5"), folder).returncode, 0)
            whole = folder.must_run("analyze checksum whole.h5")
        for name in NAMES:
            with self.subTest(name), Folder(INPUTS) as folder:
                out, err = self.interrupt(command(name), folder)
                told = re.fullmatch(
                    r"load: interrupted, and saved as (.+\.h5); to go on: (.+)\n",
                    without_notes(err),
                )
                assert told, err
                self.assertIn(told[1], folder.files())
                self.assertIn("wrote ", out)
                self.assertEqual(
                    shlex.split(told[2]), [*command(name)[:1], "--resume", *command(name)[1:]]
                )
                resumed = run(shlex.split(told[2]), folder)
                self.assertEqual((resumed.returncode, without_notes(resumed.stderr)), (0, ""))
                self.assertIn(f"resuming from {told[1]}\n", resumed.stdout)
                again = run(command(name, "--resume"), folder)
                self.assertEqual(again.stdout, f"{name} is complete\n")
                checksum = run([BIN / "analyze", "checksum", name], folder).stdout
                self.assertEqual(checksum, whole)
