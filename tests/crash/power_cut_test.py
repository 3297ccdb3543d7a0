"""The power fails after any call of a tool: whatever the disk kept, its files are complete."""

import re
import unittest

from disk import Disk
from scenario import (
    Folder,
    faults_in_files,
    faults_of_next_run,
    log_of,
    new_state,
    readable_rows,
    scenarios,
)


class PowerCut(unittest.TestCase):
    def test_the_log_is_complete_replayed_it_gives_the_folder(self):
        for scenario in scenarios():
            with self.subTest(scenario.name):
                disk = Disk(scenario.old)
                for line in log_of(scenario):
                    disk.replay(line)
                self.assertTrue(disk.files() == scenario.new)

    def test_files_are_complete_and_the_next_run_succeeds(self):
        states = next_runs = 0
        for scenario in scenarios():
            with self.subTest(scenario.name):
                disk = Disk(scenario.old)
                seen: set = set()
                for number, line in enumerate(log_of(scenario), 1):
                    disk.replay(line)
                    for files in disk.after_power_cut():
                        states += 1
                        faults = faults_in_files(scenario, files)
                        self.assertEqual(faults, [], f"after call {number}: {line[:60]}")
                        if new_state(seen, files):
                            next_runs += 1
                            self.assertEqual(faults_of_next_run(scenario, files), [], line[:60])
        print(f"{states} power cuts, {next_runs} different folders and next runs")

    def test_what_was_reported_as_written_stays(self):
        for scenario in scenarios():
            with self.subTest(scenario.name):
                disk = Disk(scenario.old)
                for line in log_of(scenario):
                    disk.replay(line)
                for files in disk.after_power_cut():
                    self.assertTrue(
                        scenario.new.items() <= files.items(), "a finished file is not on the disk"
                    )

    def test_leaves_a_record_readable_to_the_newest_checkpoint(self):
        scenario = scenarios()[0]
        with Folder(scenario.new) as folder:
            whole = readable_rows(folder.path, "r.h5")
        disk = Disk(scenario.old)
        seen: set = set()
        for line in log_of(scenario):
            disk.replay(line)
            for files in disk.after_power_cut():
                times = [float(name[3:-3]) for name in files if re.fullmatch(r"b-t.*\.h5", name)]
                if "r.h5.part" not in files or not new_state(seen, files):
                    continue
                with Folder(files) as folder:
                    rows = readable_rows(folder.path, "r.h5.part")
                self.assertEqual(rows, whole[: len(rows)])
                last = float(rows[-1].split(",")[0]) if rows else 0.0
                self.assertGreaterEqual(last + 6e-7, max(times, default=0.0), line[:60])
        self.assertGreater(len(seen), 20)
