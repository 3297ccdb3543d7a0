"""Real signals at random (seeded) moments of a run, among calls and between them."""

import random
import re
import signal
import subprocess
import time
import unittest

from scenario import (
    BIN,
    INPUTS,
    Folder,
    LONG,
    Scenario,
    faults_in_files,
    made,
    readable_rows,
    sums,
    without_temporaries,
)

LOAD = (
    "load --config driven.ini --until 2e-3 --checkpoint-every 1e-4 --record r.h5"
    " --record-every 2e-6 --fields 3e-6 -o b.h5 --sum"
)
RESUME = LOAD + " --resume"
TIMES = 500 if LONG else 40


def newest_checkpoint(files):
    return max((n for n in files if re.fullmatch(r"b-t.*\.h5", n)), default=None)


class Random(unittest.TestCase):
    whole: Scenario
    seconds: float
    rows: list

    @classmethod
    def setUpClass(cls):
        cls.whole = made("load", LOAD, INPUTS)
        with Folder(INPUTS) as folder:
            started = time.monotonic()
            folder.must_run(LOAD)
            cls.seconds = time.monotonic() - started
            cls.rows = readable_rows(folder.path, "r.h5")

    def interrupt(self, folder, command, number, moments):
        """Sends the command a signal at a random moment; returns its end and last words."""
        process = subprocess.Popen(
            [BIN / command.split()[0], *command.split()[1:]],
            cwd=folder.path,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        time.sleep(moments.uniform(0.0, self.seconds))
        process.send_signal(number)
        _, words = process.communicate(timeout=120)
        return process.returncode, words

    def check_end(self, folder):
        """The run has ended as if nothing had happened."""
        files = without_temporaries(folder.files())
        wanted = sums(self.whole.new)
        self.assertEqual({name: files.get(name) for name in wanted}, wanted)
        for name in files.keys() - self.whole.new.keys():
            self.assertRegex(name, r"^b-t0\.00\d{7}\.h5(\.sum)?$", "saved when interrupted")
        folder.must_run("analyze verify b.h5")
        folder.must_run("analyze verify r.h5")

    def test_kills_leave_checkpoints_that_lead_to_the_same_end(self):
        moments = random.Random(1)
        killed = restarts = 0
        for kill in range(TIMES):
            with self.subTest(kill=kill), Folder(self.whole.old) as folder:
                code, _ = self.interrupt(folder, LOAD, signal.SIGKILL, moments)
                killed += code == -signal.SIGKILL
                files = folder.files()
                self.assertEqual(faults_in_files(self.whole, files), [])
                if "r.h5.part" in files:
                    rows = readable_rows(folder.path, "r.h5.part")
                    self.assertEqual(rows, self.rows[: len(rows)])
                newest = newest_checkpoint(files)
                if newest is not None:
                    restarts += 1
                    folder.must_run(f"restart {newest} --until 2e-3 -o c.h5 -q")
                    end = folder.must_run("analyze checksum c.h5").strip()
                    self.assertEqual(end, self.whole.new["b.h5.sum"].decode().split()[1])
        self.assertGreater(killed, 0, "every run was over before its signal")
        print(f"{killed} kills, {restarts} restarts")

    def test_kills_one_after_another_are_resumed(self):
        moments = random.Random(2)
        killed = 0
        for row in range(TIMES):
            with self.subTest(row=row), Folder(self.whole.old) as folder:
                for _ in range(3):
                    code, words = self.interrupt(folder, RESUME, signal.SIGKILL, moments)
                    self.assertIn(code, (0, -signal.SIGKILL), words)
                    killed += code == -signal.SIGKILL
                folder.must_run(RESUME)
                self.check_end(folder)
        print(f"{TIMES} rows of {killed} kills")

    def test_interruptions_are_saved_and_the_command_that_is_told_goes_on(self):
        moments = random.Random(3)
        saved = 0
        for number in (signal.SIGINT, signal.SIGTERM) * (TIMES // 2):
            with self.subTest(signal=number), Folder(self.whole.old) as folder:
                code, words = self.interrupt(folder, LOAD, number, moments)
                self.assertIn(code, (0, -number), words)
                told = re.fullmatch(r"load: [^\n]+ to go on: \S+/(load [^\n]+)\n", words)
                if code != 0 and words and "everything was done" not in words:
                    self.assertTrue(told, words)
                    if "at its first step" not in words:
                        self.assertIsNotNone(newest_checkpoint(folder.files()))
                        saved += 1
                folder.must_run(told[1] if told else RESUME)
                self.check_end(folder)
        self.assertGreater(saved, 0, "every run was over before its signal")
        print(f"{TIMES} signals, {saved} saved")
