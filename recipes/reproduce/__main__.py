"""./reproduce.sh COMMAND [OPTION]..."""

import os
import sys
from collections.abc import Callable
from functools import partial

from report.written import hold
from rupture.errors import Failure
from rupture.tools.command_line import exit_code
from reproduce import checks, compute
from reproduce.clean import clean
from reproduce.command_line import listing, make_parser, read
from reproduce.project import PROGRAMS, RESULTS, complain, enter_root
from reproduce.processes import Processes, ensure_packages


def recipes(request, processes):
    return (compute.dry_run if request.dry_run else compute.reproduce)(request, processes)


def sweep(request, processes):
    from reproduce.sweeps import run_sweep  # h5py and more

    return run_sweep(request, processes)


def report(request, processes):
    request.turn = hold(RESULTS)
    ensure_packages(processes, "run")
    return compute.write_report(processes)


RUN: dict[str, Callable] = {
    "recipes": recipes,
    "all": recipes,
    "sweep": sweep,
    "report": report,
    "test": checks.run_tests,
    "test-slurm": checks.test_slurm,
    "check": checks.check_sources,
    "clean": clean,
}


def main(*words):
    request = read(words)
    if not request.words:
        make_parser().print_help(sys.stderr)
        return 2
    if request.command in ("list", "help"):
        print(listing() if request.command == "list" else make_parser().format_help().rstrip())
        return 0
    enter_root()
    os.environ["RUPTURE_BIN"] = os.path.abspath(request.programs or PROGRAMS)
    processes = Processes()
    if not (processes.has_turn or request.dry_run):
        raise Failure("another ./reproduce.sh is running in this folder; wait until it is done.")
    return RUN[request.command](request, processes)


if __name__ == "__main__":
    sys.exit(exit_code(partial(main, *sys.argv[1:]), complain))
