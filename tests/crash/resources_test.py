"""Room that really runs out: full disks, file-size limits, read-only places."""

import errno
import os
import resource
import subprocess
from contextlib import contextmanager
from functools import partial

import pytest

from scenario import Folder, case, check_ended, each_scenario, run

PAGE = 4096


@contextmanager
def mounted(files, options):
    """A small file system in memory; skips the test where this user cannot mount one."""
    with Folder({}) as folder:
        mount = ["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder.path]
        outcome = subprocess.run(mount, capture_output=True, text=True, check=False)
        if outcome.returncode:
            pytest.skip(f"cannot mount a small disk: {outcome.stderr.strip()}")
        try:
            for name, data in files.items():
                (folder.path / name).write_bytes(data)
            yield folder
        finally:
            subprocess.run(["umount", folder.path], check=True)


@each_scenario()
def test_full_disk(scenario):
    codes = set()
    needed = 2 * sum(map(len, scenario.new.values()))
    for free in range(0, needed, needed // 12):
        with case(free), mounted(scenario.old, f"size={needed * 3}") as folder:
            left = os.statvfs(folder.path).f_bavail * PAGE - free
            (folder.path / "ballast").write_bytes(bytes(left // PAGE * PAGE))
            outcome = run(scenario.command, folder.path)
            files = {name: data for name, data in folder.files().items() if name != "ballast"}
            codes.add(check_ended(scenario, outcome, files, errno.ENOSPC))
    assert codes == {0, 1}, "both with and without enough room"


@each_scenario()
def test_limit_of_file_size(scenario):
    codes = set()
    largest = max(map(len, scenario.new.values()))
    for most in (0, 1, 70, 80, 512, largest // 2, largest - 1, largest, 3 * largest):
        limit = partial(resource.setrlimit, resource.RLIMIT_FSIZE, (most, most))
        with case(most), Folder(scenario.old) as folder:
            outcome = run(scenario.command, folder.path, {"preexec_fn": limit})
            codes.add(check_ended(scenario, outcome, folder.files(), errno.EFBIG))
    assert codes == {0, 1}, "both with and without enough room"


@each_scenario()
def test_read_only_disk(scenario):
    with mounted(scenario.old, "size=4m") as folder:
        subprocess.run(["mount", "-o", "remount,ro", folder.path], check=True)
        outcome = run(scenario.command, folder.path)
        assert check_ended(scenario, outcome, folder.files(), errno.EROFS) == 1
