"""./reproduce.sh COMMAND [OPTION]..."""

import os
import sys
import time
from collections.abc import Callable

from rupture.errors import Failure, UsageError
from reproduce import checks, compute
from reproduce.clean import clean
from reproduce.command_line import figures, listing, make_parser, read
from reproduce.project import BESIDE_ALL, complain, enter_root, say
from reproduce.processes import Processes, ensure_packages


def recipes(request, processes):
    """Those that are named, or all with their report."""
    started = time.monotonic()
    is_all = request.command == "all"
    named = [name for name in figures() if name not in BESIDE_ALL] if is_all else request.words
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
        print(make_parser().format_help(), file=sys.stderr)
        return 2
    if request.command in ("list", "help"):
        print(listing() if request.command == "list" else make_parser().format_help())
        return 0
    enter_root()
    return RUN[request.command](request, Processes())


def discard_output():
    """What is left of it, which Python writes at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def main_or_sentence(*words):
    """The exit code: 1 if a command failed, 2 if the command line is wrong."""
    try:
        try:
            return main(*words)
        finally:  # also after --help
            sys.stdout.flush()
    except UsageError as error:
        complain(error)
        return 2
    except Failure as failure:
        complain(failure)
        return 1
    except BrokenPipeError:  # such as that of `| head`
        discard_output()
        return 141
    except OSError as error:
        discard_output()
        complain(f"{error.filename or 'standard output'}: {error.strerror}.")
        return 1


if __name__ == "__main__":
    sys.exit(main_or_sentence(*sys.argv[1:]))
