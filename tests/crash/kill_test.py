"""A tool is killed at each call by which a disk can change, also in the middle of a write."""

import signal

from scenario import case, check_files, check_next_run, each_scenario
from scenario import faulted, log_of, new_state, readable_rows


def moments(scenario):
    """(number, fault) of all kills after which the disk may look different."""
    for number, line in enumerate(log_of(scenario), 1):
        call, *arguments = line.split()
        if call == "write":
            yield number, "tear"
        reads = call in ("read", "close", "fsync") or call == "open" and arguments[-1] == "read"
        if not reads and not call.startswith("failed-"):
            yield number, "kill"


@each_scenario()
def test_a_kill_at_any_call_leaves_complete_files_and_the_next_run_succeeds(scenario):
    seen: set = set()
    whole = readable_rows(scenario.new, "r.h5") if "r.h5" in scenario.new else []
    flushed = 0
    for number, fault in moments(scenario):
        with case(number, fault):
            outcome, files = faulted(scenario, fault, number)
            assert outcome.returncode == -signal.SIGKILL
            check_files(scenario, files)
            if whole and "r.h5.part" in files:  # readable to its last flush
                rows = readable_rows(files, "r.h5.part")
                assert rows == whole[: len(rows)]
                assert len(rows) >= flushed, "samples were lost again"
                flushed = len(rows)
            if new_state(seen, files):
                check_next_run(scenario, files)
    assert flushed == len(whole)
