"""Each call of a tool that touches a file fails in turn: full or broken disks, quotas, limits."""

import errno
from errno import EEXIST, EINVAL, EIO, EPERM

import pytest

from scenario import INPUTS, LOAD, PREPARE, case, check_ended, check_next_run, each_scenario
from scenario import faulted, kept_in, log_of, made, new_state, sums, without_notes

ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS)
FAULTS = [f"{error}" for error in (EIO, *ROOM)]  # one after the other
FAULTS += [f"{error}+" for error in ROOM]  # so do later calls that need room


def check(scenario, outcome, files, fault):
    """Either the failed call was not needed, or the tool says what happened and tidies up."""
    notes, outcome.stderr = outcome.stderr, without_notes(outcome.stderr)
    if outcome.returncode == 0 and notes:  # a run resumed earlier, which has other provenance
        assert (outcome.stderr, sums(files)) == ("", sums(scenario.new))
    else:
        check_ended(scenario, outcome, files, int(fault.rstrip("+")))


@each_scenario()
def test_a_failure_of_any_call_is_reported_and_leaves_complete_files(scenario):
    seen: set = set()
    for number, line in enumerate(log_of(scenario), 1):
        fault = FAULTS[number % len(FAULTS)]
        with case(fault, number, line[:60]):
            outcome, files = faulted(scenario, fault, number)
            check(scenario, outcome, files, fault)
            if new_state(seen, files):
                check_next_run(scenario, files)


@pytest.mark.parametrize("lasting", ["", "+"])  # then links fail, too
@pytest.mark.parametrize(
    "error, option, code", [(EINVAL, "", 0), (EIO, "", 0), (EEXIST, "", 1), (EPERM, "--force", 3)]
)
def test_a_file_gets_its_name_in_another_way_or_is_kept(error, lasting, option, code):
    prepare = made("prepare", f"{PREPARE} {option}", INPUTS)
    number = next(n for n, line in enumerate(log_of(prepare), 1) if line.endswith(" b.h5"))
    outcome, files = faulted(prepare, f"{error}{lasting}", number)
    assert (outcome.returncode, prepare.is_done(files)) == (code, code == 0)
    assert kept_in(outcome.stderr, files, prepare.new) == ["b.h5"] * bool(code)


def test_a_folder_without_renaming_is_refused_before_the_run():
    load = made("load", LOAD, INPUTS)
    number = next(n for n, line in enumerate(log_of(load), 1) if line.startswith("rename"))
    outcome, files = faulted(load, f"{EPERM}", number)
    assert (outcome.returncode, outcome.stdout, files) == (3, "", load.old)


@each_scenario()
def test_a_short_write_is_no_failure(scenario):
    for number, line in enumerate(log_of(scenario), 1):
        if line.startswith("write"):
            outcome, files = faulted(scenario, "short", number)
            assert (outcome.returncode, outcome.stderr) == (0, ""), number
            assert scenario.is_done(files), number
