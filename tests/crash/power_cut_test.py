"""The power fails after any call of a tool: whatever the disk kept, its files are complete."""

import re

from disk import Disk
from scenario import case, check_files, check_next_run, each_scenario
from scenario import log_of, new_state, readable_rows, scenarios


def replayed(scenario):
    """Each call, and the disk after it."""
    disk = Disk(scenario.old)
    for line in log_of(scenario):
        disk.replay(line)
        yield line[:60], disk


@each_scenario()
def test_the_log_is_complete_and_what_was_reported_as_written_stays(scenario):
    *_, (_, disk) = replayed(scenario)
    assert scenario.is_done(disk.files())
    for files in disk.after_power_cut():
        kept = scenario.new.items() <= files.items()
        assert kept, "a finished file is not on the disk"


@each_scenario()
def test_files_are_complete_and_the_next_run_succeeds(scenario):
    seen: set = set()
    for line, disk in replayed(scenario):
        for files in disk.after_power_cut():
            with case(line):
                check_files(scenario, files)
                if new_state(seen, files):
                    check_next_run(scenario, files)


def test_a_record_is_readable_to_the_newest_checkpoint():
    scenario = scenarios()[0]
    whole = readable_rows(scenario.new, "r.h5")
    seen: set = set()
    for line, disk in replayed(scenario):
        for files in disk.after_power_cut():
            times = [float(name[3:-3]) for name in files if re.fullmatch(r"b-t.*\.h5", name)]
            if "r.h5.part" not in files or not new_state(seen, files):
                continue
            rows = readable_rows(files, "r.h5.part")
            assert rows == whole[: len(rows)], line
            last = float(rows[-1].split(",")[0]) if rows else 0.0
            assert last + 6e-7 >= max(times, default=0.0), line
    assert len(seen) > 20
