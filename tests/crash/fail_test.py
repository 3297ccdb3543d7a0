"""Each call of a tool that touches a file fails in turn: full or broken disks, quotas, limits."""

import errno
import os
import unittest

from scenario import (
    Folder,
    INPUTS,
    LONG,
    TEMPORARY,
    faults_in_files,
    faults_of_failure,
    faults_of_next_run,
    log_of,
    made,
    new_state,
    run_with_fault,
    scenarios,
    sums,
    without_notes,
)

LASTING = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS)  # so do later calls that need room
ONCE = (errno.EIO, errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS)


def errors_at(number):
    """The failures to try at a call, as (fault, errno): all, or each call two of them in turn."""
    lasting = [(f"{error}+", error) for error in LASTING]
    once = [(f"{error}", error) for error in ONCE]
    if LONG:
        return lasting + once
    return [lasting[number % len(lasting)], once[number % len(once)]]


class Failure(unittest.TestCase):
    def check(self, scenario, outcome, files, error):
        """Either the failed call was not needed, or the tool says what happened and tidies up."""
        said, outcome.stderr = outcome.stderr, without_notes(outcome.stderr)
        if outcome.returncode == 0:
            self.assertEqual(outcome.stderr, "")
            # A run resumed from an earlier checkpoint has other provenance.
            same = sums(files) == sums(scenario.new) if said else files == scenario.new
            self.assertTrue(same, "not all is written")
            return False
        self.assertEqual(faults_of_failure(outcome, os.strerror(error), scenario), [])
        self.assertEqual(faults_in_files(scenario, files), [])
        self.assertEqual([name for name in files if TEMPORARY.match(name)], [])
        return True

    def test_of_any_call_is_reported_and_leaves_complete_files(self):
        failures = failed = next_runs = 0
        for scenario in scenarios():
            seen: set = set()
            for number, line in enumerate(log_of(scenario), 1):
                for fault, error in errors_at(number):
                    with self.subTest(scenario.name, call=line[:60], number=number, fault=fault):
                        failures += 1
                        with Folder(scenario.old) as folder:
                            outcome = run_with_fault(scenario.command, folder.path, fault, number)
                            files = folder.files()
                        failed += self.check(scenario, outcome, files, error)
                        if new_state(seen, files):
                            next_runs += 1
                            self.assertEqual(faults_of_next_run(scenario, files), [])
        print(f"{failures} failing calls, {failed} failed runs, {next_runs} next runs")

    def test_is_not_what_a_disk_without_exclusive_renaming_does(self):
        prepare = made("prepare", "prepare --config rest.ini --tau-bar 0.5 -o b.h5", INPUTS)
        number = next(n for n, line in enumerate(log_of(prepare), 1) if line.endswith(" b.h5"))
        for error in (errno.EINVAL, errno.ENOSYS):
            with self.subTest(error=error), Folder(INPUTS) as folder:
                outcome = run_with_fault(prepare.command, folder.path, f"{error}", number)
                self.assertEqual((outcome.returncode, outcome.stderr), (0, ""))
                self.assertTrue(folder.files() == prepare.new)

    def test_is_not_what_a_short_write_is(self):
        for scenario in scenarios():
            for number, line in enumerate(log_of(scenario), 1):
                if not line.startswith("write"):
                    continue
                with self.subTest(scenario.name, number=number), Folder(scenario.old) as folder:
                    outcome = run_with_fault(scenario.command, folder.path, "short", number)
                    self.assertEqual((outcome.returncode, outcome.stderr), (0, ""))
                    self.assertTrue(folder.files() == scenario.new)
