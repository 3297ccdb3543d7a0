"""A sweep by ./reproduce.sh that is interrupted, killed or damaged: nothing goes on by itself, and
the same command completes it (recipes/common/reproduce/)."""

import json
import os
import signal
import time
import unittest
from pathlib import Path

from stand_ins import SWEEP, WITHIN, Project, write_program


def described(name, *options):
    """As a program says it of itself; the options take numbers."""
    numbers = [{"name": word, "short": None, "kind": "number", "unit": "1"} for word in options]
    return {"name": name, "one_needed": [], "options": numbers}


# Knows enough of analyze for a sweep to be planned.
QUANTITIES = {"parameters": [], "quantities": [{"name": "stress.F_T", "unit": "N"}]}
ANALYZE = f"""#!/bin/sh
case "$*" in
  *quantities*) echo '{json.dumps(QUANTITIES)}';;
  *--describe*) echo '{json.dumps(described("analyze stress"))}';;
  *) echo '{{"F_T": 1}}';;
esac
"""
# Waits for long, unless there is a file `go` in the project's folder.
PREPARE = f"""#!/bin/sh
case "$*" in
  *--describe*) echo '{json.dumps(described("prepare", "tau-bar"))}'; exit;;
esac
echo $$ >> ROOT/running
[ -e ROOT/go ] || exec sleep 300
"""


class Ending(Project):
    def setUp(self):
        super().setUp()
        (self.root / "my.ini").write_text(SWEEP)
        for name in ("load", "modify-phi", "restart"):
            write_program(self.bin / name, "#!/bin/sh\n")
        write_program(self.bin / "analyze", ANALYZE)
        write_program(self.bin / "prepare", PREPARE.replace("ROOT", str(self.root)))

    def sweep(self):
        return self.start("sweep", "my.ini", "--programs", "bin", "--cores", "2")

    def wait_for(self, condition):
        end = time.monotonic() + WITHIN
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def running(self):
        """Programs of points that have not ended."""
        path = self.root / "running"
        numbers = path.read_text().split() if path.exists() else []
        return [number for number in numbers if self.is_alive(number)]

    def is_alive(self, number):
        try:
            return Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
        except OSError:
            return False

    def started(self):
        process = self.sweep()
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for(lambda: len(self.running()) == 2 or process.poll() is not None)
        self.assertIsNone(process.poll())
        return process

    def test_a_signal_ends_all_that_runs(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number.name):
                process = self.started()
                process.send_signal(number)
                self.assertEqual(process.wait(WITHIN), code)
                self.assertEqual(self.running(), [])

    def test_a_signal_ends_what_was_started_in_the_background_of_a_script(self):
        ignored = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            process = self.started()
        finally:
            signal.signal(signal.SIGINT, ignored)
        process.terminate()
        self.assertEqual(process.wait(WITHIN), 143)
        self.assertEqual(self.running(), [])

    def test_a_reader_that_has_gone_does_not_stop_it(self):
        (self.root / "go").touch()
        process = self.sweep()
        process.stdout.close()
        process.stderr.read()
        self.assertEqual(process.wait(WITHIN), 141)
        self.assertEqual(len(list((self.root / "results/data/points").glob("*.json"))), 2)
        self.assertTrue((self.root / "results/sweeps/my/my.csv").exists())

    def test_a_point_that_other_programs_have_computed_since_is_computed_again(self):
        (self.root / "go").touch()
        (self.root / "other.ini").write_text(SWEEP.replace("0.1, 0.2", "0.1"))
        first = (self.bin / "load").read_text()
        for sweep, load in (("my", first), ("other", "#!/bin/sh\n# 2\n"), ("my", first)):
            write_program(self.bin / "load", load)
            done = self.call("sweep", f"{sweep}.ini", "--programs", "bin")
            self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("2 points: 2 done.\nComputed now: 1; there before: 1.", done.stdout)

    def test_a_damaged_result_is_computed_again(self):
        (self.root / "go").touch()
        self.call("sweep", "my.ini", "--programs", "bin")
        next((self.root / "results/data/points").glob("*.json")).write_text("{")
        done = self.call("sweep", "my.ini", "--programs", "bin")
        self.assertIn("2 points: 2 done.\nComputed now: 1; there before: 1.", done.stdout)

    def test_a_second_run_is_refused_while_the_first_one_runs(self):
        self.started()
        done = self.call("sweep", "my.ini", "--programs", "bin")
        sentence = "reproduce.sh: another ./reproduce.sh is running in this folder; wait until"
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
        self.assertIn(sentence, done.stderr)

    def test_what_a_killed_run_leaves_behind_ends_by_itself(self):
        process = self.started()
        process.kill()
        process.wait()
        self.wait_for(lambda: not self.running())

    def test_after_a_killed_run_the_same_command_goes_on(self):
        process = self.started()
        process.kill()
        process.wait()
        (self.root / "go").touch()
        done = self.call("sweep", "my.ini", "--programs", "bin")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 points: 2 done.", done.stdout)

    def test_snakemake_alone_may_be_killed(self):
        process = self.started()
        (pipeline,) = [
            int(folder.name)
            for folder in Path("/proc").glob("[0-9]*")
            if self.is_child(folder, process.pid) and self.runs_pipeline(folder)
        ]
        os.kill(pipeline, signal.SIGKILL)
        self.assertEqual(process.wait(WITHIN), 1)
        self.wait_for(lambda: not self.running())

    def is_child(self, folder, parent):
        try:
            return (folder / "stat").read_text().rsplit(")", 1)[1].split()[1] == str(parent)
        except OSError:
            return False

    def runs_pipeline(self, folder):
        return b"reproduce/pipeline.py" in (folder / "cmdline").read_bytes()


if __name__ == "__main__":
    unittest.main()
