"""Room and permissions that really run out: full disks, file-size limits, read-only places."""

import errno
import os
import resource
import shutil
import subprocess
import unittest
from functools import partial

from scenario import Folder, TEMPORARY, faults_in_files, faults_of_failure, run, scenarios

NOBODY = 65534
PAGE = 4096


class Mounted:
    """A small file system in memory; skips the test where this user cannot mount one."""

    def __init__(self, test, options):
        self.folder = Folder({})
        mount = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", self.folder.path]
        outcome = subprocess.run(mount, capture_output=True, text=True)
        if outcome.returncode != 0:
            shutil.rmtree(self.folder.path)
            test.skipTest(f"cannot mount a small disk: {outcome.stderr.strip()}")

    def __enter__(self):
        return self.folder

    def __exit__(self, *_):
        subprocess.run(["umount", self.folder.path], check=True)
        shutil.rmtree(self.folder.path)


def readable_by_all(folder):
    """Lets other users in, also where the system's mask does not."""
    folder.path.chmod(0o777)
    for entry in folder.path.iterdir():
        entry.chmod(0o666)


class Resources(unittest.TestCase):
    def check(self, scenario, outcome, folder, error):
        """The command succeeded, or failed for this reason and left the folder in order."""
        files = {name: data for name, data in folder.files().items() if name != "ballast"}
        self.assertEqual(faults_in_files(scenario, files), [])
        self.assertEqual([name for name in files if TEMPORARY.match(name)], [])
        if outcome.returncode == 0:
            self.assertTrue(files == scenario.new)
        else:
            self.assertEqual(faults_of_failure(outcome, os.strerror(error), scenario), [])
        return outcome.returncode

    def run_as_nobody(self, command, folder):
        try:
            return run(command, folder.path, {"user": NOBODY, "group": NOBODY, "extra_groups": []})
        except PermissionError:
            self.skipTest("another user cannot be become, or cannot run the tools in this folder")

    def test_full_disk(self):
        codes = set()
        for scenario in scenarios():
            needed = 2 * sum(map(len, scenario.new.values()))
            for free in range(0, needed, needed // 12):
                with self.subTest(scenario.name, free=free):
                    with Mounted(self, f"size={needed * 3}") as folder:
                        for name, data in scenario.old.items():
                            (folder.path / name).write_bytes(data)
                        left = os.statvfs(folder.path).f_bavail * PAGE - free
                        (folder.path / "ballast").write_bytes(bytes(left // PAGE * PAGE))
                        outcome = run(scenario.command, folder.path)
                        codes.add(self.check(scenario, outcome, folder, errno.ENOSPC))
        self.assertEqual(codes, {0, 1}, "both with and without enough room")

    def test_limit_of_file_size(self):
        codes = set()
        for scenario in scenarios():
            largest = max(map(len, scenario.new.values()))
            for most in (0, 1, 70, 80, 512, largest // 2, largest - 1, largest, 3 * largest):
                limit = partial(resource.setrlimit, resource.RLIMIT_FSIZE, (most, most))
                with self.subTest(scenario.name, most=most), Folder(scenario.old) as folder:
                    outcome = run(scenario.command, folder.path, {"preexec_fn": limit})
                    codes.add(self.check(scenario, outcome, folder, errno.EFBIG))
        self.assertEqual(codes, {0, 1}, "both with and without enough room")

    def test_folder_that_may_not_be_written(self):
        for scenario in scenarios():
            with self.subTest(scenario.name), Folder(scenario.old) as folder:
                readable_by_all(folder)
                folder.path.chmod(0o555)
                if os.geteuid() == 0:
                    outcome = self.run_as_nobody(scenario.command, folder)
                else:
                    outcome = run(scenario.command, folder.path)
                self.assertEqual(faults_of_failure(outcome, "Permission denied", scenario), [])
                self.assertTrue(folder.files() == scenario.old)

    def test_read_only_disk(self):
        for scenario in scenarios():
            with self.subTest(scenario.name), Mounted(self, "size=4m") as folder:
                for name, data in scenario.old.items():
                    (folder.path / name).write_bytes(data)
                remount = ["mount", "-o", "remount,ro", folder.path]
                subprocess.run(remount, check=True)
                outcome = run(scenario.command, folder.path)
                self.assertEqual(self.check(scenario, outcome, folder, errno.EROFS), 1)
