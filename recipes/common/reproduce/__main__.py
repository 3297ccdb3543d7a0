"""./reproduce.sh COMMAND [OPTION]..."""

import json
import os
import sys
import time
from collections.abc import Callable

from reproduce import checks, compute
from reproduce.clean import clean
from reproduce.command_line import description, figures, listing, make_parser, read
from reproduce.project import BESIDE_ALL, Failure, UsageError, complain, enter_root, say
from reproduce.processes import Processes, ensure_packages


def duration(seconds):
    seconds = round(seconds)
    return f"{seconds} s" if seconds < 60 else f"{seconds // 60} min {seconds % 60} s"


def recipes(request, processes):
    started = time.monotonic()
    compute.reproduce(request, request.words, processes)
    compute.write_crate(processes)
    say(f"\nDone in {duration(time.monotonic() - started)}.")


def everything(request, processes):
    started = time.monotonic()
    names = [name for name in figures() if name not in BESIDE_ALL]
    compute.reproduce(request, names, processes)
    say()
    code = compute.write_report_if_needed(processes)
    say(f"\nDone in {duration(time.monotonic() - started)}.")
    return code


def report(_, processes):
    ensure_packages(processes, "run")
    return compute.write_report(processes)


RUN: dict[str, Callable] = {
    "recipes": recipes,
    "all": everything,
    "sweep": compute.run_sweep,
    "report": report,
    "test": checks.run_tests,
    "test-slurm": checks.test_slurm,
    "check": checks.check_sources,
    "tidy": checks.tidy_sources,
    "clean": clean,
}


ANSWERS: dict[str, Callable] = {
    "help": lambda: make_parser().format_help(),
    "describe": lambda: json.dumps(description()) + "\n",
    "list": lambda: listing() + "\n",
}


def main(*words):
    request = read(words)
    if request.command in ANSWERS:
        print(ANSWERS[request.command](), end="")
        return 0
    if not request.command:
        print(make_parser().format_help(), end="", file=sys.stderr)
        return 2
    enter_root()
    return RUN[request.command](request, Processes())


def discard_output():
    """What is left of it, which Python writes at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def main_or_sentence(*words):
    """The exit code: 1 if a command failed, 2 if the command line makes no sense."""
    try:
        code = main(*words)
        sys.stdout.flush()
        return code
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
