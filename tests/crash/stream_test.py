"""Standard streams that are closed or lose their reader, and a record that is moved meanwhile."""

import shlex
import signal
import subprocess
import time
import unittest

from scenario import BIN, INPUTS, Folder, made, sums

LOAD = (
    "load --config driven.ini --until 1e-3 --set driving.V=0.01 --record r.h5 --record-every 1e-6"
    " -o b.h5 --sum"
)


class Stream(unittest.TestCase):
    def setUp(self):
        self.whole = sums(made("alone", LOAD, INPUTS).new)
        self.folder = Folder(INPUTS)
        self.addCleanup(self.folder.__exit__)

    def run_in_shell(self, redirections):
        """The exit code of the run as bash gives it, and its last words."""
        script = f"{shlex.quote(str(BIN))}/{LOAD} {redirections}"
        command = ["bash", "-c", f"set -o pipefail; {script}"]
        ended = subprocess.run(command, cwd=self.folder.path, capture_output=True, text=True)
        return ended.returncode, ended.stderr

    def check_files(self):
        self.assertEqual(sums(self.folder.files()), self.whole)
        for name in ("b.h5", "r.h5"):
            self.folder.must_run(f"analyze verify {name}")

    def test_whose_reader_goes_away_loses_no_file(self):
        self.assertEqual(self.run_in_shell("| true"), (128 + signal.SIGPIPE, ""))
        self.check_files()

    def test_that_is_closed_is_no_file_of_the_run(self):
        failed = "load: cannot write to standard output\n"
        for closed, end in (
            ("2>&-", (0, "")),
            ("<&- 2>&-", (0, "")),
            (">&-", (1, failed)),
            ("<&- >&- 2>&-", (1, "")),
        ):
            with self.subTest(closed):
                self.assertEqual(self.run_in_shell(f"--force {closed}"), end)
                self.check_files()

    def test_of_a_record_is_the_same_file_under_another_name(self):
        tool, *options = shlex.split(LOAD)
        with subprocess.Popen(
            [BIN / tool, *options, "-q"], cwd=self.folder.path, stderr=subprocess.PIPE
        ) as process:
            part = self.folder.path / "r.h5.part"
            end = time.monotonic() + 60
            while not part.exists() and time.monotonic() < end:
                time.sleep(0.0005)
            part.rename(self.folder.path / "moved")
            _, said = process.communicate(timeout=120)
        self.assertEqual((process.returncode, said), (0, b""))
        self.check_files()
        self.assertIn("moved", self.folder.files())
