"""A tool is killed, or the power fails, after any call by which it changes files: whatever the disk
kept, its files are complete. A killed tool is a power cut after which all was kept."""

import re

from disk import Disk
from scenario import case, check_files, check_next_run, each_scenario
from scenario import log_of, new_state, readable_rows


def check_record(scenario, files, whole):
    """Returns the samples of the unfinished record, which reach to the newest checkpoint."""
    rows = readable_rows(files, "r.h5.part")
    assert rows == whole[: len(rows)]
    written = [name for name, data in files.items() if data == scenario.new.get(name)]
    times = [float(name[3:-3]) for name in written if re.fullmatch(r"b-t.*\.h5", name)]
    last = float(rows[-1].split(",")[0]) if rows else 0.0
    assert last + 6e-7 >= max(times, default=0.0)
    return rows


@each_scenario()
def test_files_are_complete_and_the_next_run_succeeds(scenario):
    disk = Disk(scenario.old)
    seen: set = set()
    whole = readable_rows(scenario.new, "r.h5") if "r.h5" in scenario.new else []
    flushed = 0
    for line in log_of(scenario):
        disk.replay(line)
        for files in disk.after_power_cut():
            with case(line[:60]):
                check_files(scenario, files)
                if not new_state(seen, files):
                    continue
                if "r.h5.part" in files:
                    rows = check_record(scenario, files, whole)
                    if files == disk.files():
                        assert len(rows) >= flushed, "samples were lost again"
                        flushed = len(rows)
                check_next_run(scenario, files)
    assert flushed == len(whole)
    assert scenario.is_done(disk.files()), "the log is not complete"
    for files in disk.after_power_cut():
        kept = scenario.new.items() <= files.items()
        assert kept, "a finished file is not on the disk"
