"""A tool is killed at each call by which a disk can change, also in the middle of a write."""

import signal
import unittest

from scenario import (
    Folder,
    faults_in_files,
    faults_of_next_run,
    log_of,
    new_state,
    readable_rows,
    run_with_fault,
    scenarios,
)


def moments(log):
    """(number, fault) of all kills after which the disk may look different."""
    for number, line in enumerate(log, 1):
        call, *arguments = line.split()
        if call == "write":
            yield number, "tear"
        reads = call in ("read", "close", "fsync") or call == "open" and arguments[-1] == "read"
        if not reads and not call.startswith("failed-"):
            yield number, "kill"


class Kill(unittest.TestCase):
    def test_at_any_call_leaves_complete_files_and_the_next_run_succeeds(self):
        kills = next_runs = 0
        for scenario in scenarios():
            seen: set = set()
            for number, fault in moments(log_of(scenario)):
                with self.subTest(scenario.name, call=number, fault=fault):
                    kills += 1
                    with Folder(scenario.old) as folder:
                        outcome = run_with_fault(scenario.command, folder.path, fault, number)
                        files = folder.files()
                    self.assertEqual(outcome.returncode, -signal.SIGKILL)
                    self.assertEqual(faults_in_files(scenario, files), [])
                    if new_state(seen, files):
                        next_runs += 1
                        self.assertEqual(faults_of_next_run(scenario, files), [])
        print(f"{kills} kills, {next_runs} different folders and next runs")

    def test_at_any_call_leaves_a_record_readable_to_its_last_flush(self):
        for scenario in scenarios():
            with Folder(scenario.new) as folder:
                if "r.h5" not in scenario.new:
                    continue
                whole = readable_rows(folder.path, "r.h5")
            flushed = 0
            for number, fault in moments(log_of(scenario)):
                with self.subTest(scenario.name, call=number, fault=fault):
                    with Folder(scenario.old) as folder:
                        run_with_fault(scenario.command, folder.path, fault, number)
                        if "r.h5.part" not in folder.files():
                            continue
                        rows = readable_rows(folder.path, "r.h5.part")
                    self.assertEqual(rows, whole[: len(rows)])
                    self.assertGreaterEqual(len(rows), flushed, "samples were lost again")
                    flushed = len(rows)
            self.assertEqual(flushed, len(whole))
