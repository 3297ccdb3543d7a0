"""What we may use of the machine: CPU affinity and control groups, of both versions, limit it."""

import os
from contextlib import suppress
from pathlib import Path

OWN, ALL = Path("/proc/self/cgroup"), Path("/sys/fs/cgroup")
ROOM = 1024  # megabytes that a program may need


def limits(*files):
    """The numbers in these files, for each of our control groups, and for those above it."""
    for line in OWN.read_text().splitlines() if OWN.exists() else ():
        _, controllers, path = line.split(":", 2)
        for folder in (ALL / controllers / path[1:] / "file").parents:
            with suppress(OSError, ValueError):  # there is no such file, or it says "max"
                yield [int(n) for name in files for n in (folder / name).read_text().split()]


def usable_cores():
    quotas = [*limits("cpu.max"), *limits("cpu.cfs_quota_us", "cpu.cfs_period_us")]
    allowed = len(os.sched_getaffinity(0))
    return min([allowed, *(max(1, quota // period) for quota, period in quotas if quota > 0)])


def usable_megabytes():
    present = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return min([[present], *limits("memory.max"), *limits("memory.limit_in_bytes")])[0] // 2**20


def programs_at_a_time(megabytes=None, threads=1):
    """What each may need."""
    return max(1, min(usable_cores() // threads, usable_megabytes() // (megabytes or ROOM)))
