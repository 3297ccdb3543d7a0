"""./reproduce.sh COMMAND [OPTION]..."""

import os
import sys
import time
from collections.abc import Callable
from functools import partial

from chains.preview import preview
from rupture.errors import Failure
from rupture.tools.command_line import exit_code
from reproduce import checks, compute
from reproduce.clean import clean
from reproduce.command_line import figures, listing, make_parser, read
from reproduce.project import BESIDE_ALL, PROGRAMS, complain, enter_root, say
from reproduce.processes import Processes, ensure_packages


def recipes(request, processes):
    """Computes the named recipes, or all and their report."""
    started = time.monotonic()
    if request.dry_run:
        for line in (line for recipe in request.words for line in preview(recipe)):
            say(line)
        return 0
    is_all = request.command == "all"
    of_all = [name for name in figures() if name not in BESIDE_ALL and "/" not in name]
    named = of_all if is_all else request.words
    compute.reproduce(request, named, processes)
    code = (compute.write_report_if_needed if is_all else compute.write_crate)(processes)
    minutes, seconds = divmod(round(time.monotonic() - started), 60)
    say(f"\nDone in {f'{minutes} min ' if minutes else ''}{seconds} s.")
    return code


def report(_, processes):
    ensure_packages(processes, "run")
    return compute.write_report(processes)


RUN: dict[str, Callable] = {
    "recipes": recipes,
    "all": recipes,
    "sweep": compute.run_sweep,
    "report": report,
    "test": checks.run_tests,
    "test-slurm": checks.test_slurm,
    "check": checks.check_sources,
    "tidy": checks.tidy_sources,
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
