"""The command line of ./reproduce.sh."""

import argparse
import os
import re
import textwrap
from dataclasses import asdict, dataclass
from pathlib import Path

from reproduce.project import BESIDE_ALL, PROFILES, WORK, UsageError, recipe_names

USAGE = """\
Usage: ./reproduce.sh COMMAND [OPTION]...

Commands
  fig3 (or another figure)  install what is missing, build, compute, draw, print the claims
  all                       the same for everything but choices and convergence, and the report
  sweep FILE.ini            run the model for all values that the file lists, and write a table and
                            a picture (docs/sweeps.md)
  report                    write results/index.html: all figures and claims on one page
  test                      build and run the tests
  test-slurm                install SLURM, start it here and compute through it (some minutes)
  check                     look for faults in the sources and in their layout
  tidy                      look for more of them, with clang-tidy (some minutes)
  list                      list the figures and other recipes
  clean                     delete what these commands wrote and built, and name what is left

Options
"""


@dataclass(frozen=True)
class Option:
    """The fields are those of --describe (docs/schema.md)."""

    name: str
    help: str
    short: str | None = None
    kind: str = "flag"
    value: str = ""
    unit: str = ""
    default: str | None = None


OPTIONS = (
    Option("dry-run", "of a sweep: say how many points there are, and compute none"),
    Option(
        "from-scratch",
        "compute the checkpoints that the figures start from, too, instead of using those in"
        " checkpoints/",
    ),
    Option(
        "profile",
        "where commands run: local, slurm, another folder of recipes/common/profiles/, or the"
        " path of one (docs/cluster.md)",
        kind="text",
        value="NAME",
        default="local",
    ),
    Option(
        "programs",
        "use the programs there instead of building them",
        kind="text",
        value="FOLDER",
    ),
    Option(
        "cores",
        "use N cores of this machine (default: all)",
        kind="integer",
        value="N",
        unit="1",
    ),
    Option("describe", "print name, options and input as one JSON object and stop"),
    Option("help", "print this text", short="h"),
)

COMMANDS = {
    "all": f"everything above but {' and '.join(BESIDE_ALL)}",
    "sweep": "a sweep of your own",
    "report": "the page of all figures and claims",
    "test": "the tests",
    "test-slurm": "the tests of SLURM",
    "check": "faults and layout of the sources",
    "tidy": "more faults",
    "list": "this list",
    "clean": "delete what was written and built here",
}


NEED_SOURCES = ("test", "test-slurm", "check", "tidy")
if WORK:
    COMMANDS = {name: text for name, text in COMMANDS.items() if name not in NEED_SOURCES}


def option_text(option):
    names = f"-{option.short}, --{option.name}" if option.short else f"--{option.name}"
    first = f"{names} {option.value}".strip().ljust(26)
    default = f" (default: {option.default})" if option.default else ""
    return textwrap.fill(
        first + option.help + default, 100, initial_indent="  ", subsequent_indent=" " * 28
    )


def help_text():
    """Of `rupture reproduce` without the commands that are about the sources."""
    text = USAGE + "".join(option_text(option) + "\n" for option in OPTIONS)
    if not WORK:
        return text
    of_sources = tuple(f"  {name} " for name in NEED_SOURCES)
    lines = [line for line in text.splitlines(True) if not line.startswith(of_sources)]
    text = "".join(lines).replace("./reproduce.sh", "rupture reproduce")
    return text.replace("install what is missing, build, compute", "compute")


def description():
    """As the other programs describe themselves (docs/schema.md, Programs as JSON)."""
    return {
        "name": "reproduce",
        "summary": "compute figures of the paper, their claims, and sweeps of your own",
        "synopsis": "reproduce COMMAND [options]",
        "purpose": "Computes the figures that are named, or all, in results/ of the current folder;"
        " rupture reproduce list lists them.",
        "input": "word",
        "words": [*sorted(recipe_names(), key=natural), *COMMANDS],
        "outputs": [],
        "parameters": False,
        "one_needed": [],
        "options": [asdict(option) for option in OPTIONS],
    }


class Parser(argparse.ArgumentParser):
    """Says what is wrong in a sentence of its own."""

    def error(self, message):
        for pattern, sentence in (
            (r"unrecognized arguments: (\S+)", "there is no option '{}'."),
            (r"argument (\S+): expected one argument", "{} needs a value."),
            (r"argument (\S+): ignored explicit argument", "{} takes no value."),
            (r"argument \S+: (.*)", "{}"),
        ):
            if found := re.match(pattern, message, re.S):
                raise UsageError(f"{sentence.format(found[1])} See --help.")
        raise UsageError(f"{message}. See --help.")


def whole_number(text):
    if not re.fullmatch("[1-9][0-9]{0,3}", text):
        raise argparse.ArgumentTypeError(f"--cores needs a whole number from 1, not '{text}'.")
    return int(text)


def read_words(words):
    parser = Parser(add_help=False, allow_abbrev=False)
    parser.add_argument("commands", nargs="*")
    for option in OPTIONS:
        names = [f"-{option.short}"] if option.short else []
        names.append(f"--{option.name}")
        if option.kind == "flag":
            parser.add_argument(*names, action="store_true")
        elif option.kind == "integer":
            parser.add_argument(*names, type=whole_number)
        else:
            parser.add_argument(*names, default=option.default)
    return parser.parse_intermixed_args(words)


@dataclass(frozen=True)
class Request:
    """The request of a command line; paths are absolute."""

    command: str  # of COMMANDS, or `recipes`
    recipes: list
    file: Path | None  # of a sweep
    dry_run: bool
    from_scratch: bool
    profile: Path
    programs: Path | None  # None: those that are built here
    cores: int


def natural(name):
    """fig2 before fig10."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def title_of(recipe):
    """The first line of its README, without the hash marks."""
    try:
        first = Path(f"recipes/{recipe}/README.md").read_text(encoding="utf-8").splitlines()[:1]
    except OSError:
        first = []
    return "".join(first).lstrip("# ")


def listing():
    titles = {name: title_of(name) for name in sorted(recipe_names(), key=natural)} | COMMANDS
    return "\n".join(f"  {name:<10} {title}".rstrip() for name, title in titles.items())


def profile_at(text, caller):
    folder = caller / text if "/" in text else PROFILES.absolute() / text
    if not text or not (folder / "config.yaml").exists():
        raise UsageError(
            f"--profile '{text}' is none: {folder}/config.yaml does not exist. See --help."
        )
    return folder.resolve()


def programs_at(text, caller):
    folder = caller / text
    if not text or not os.access(folder / "load", os.X_OK):
        raise UsageError(
            f"--programs '{text}' is no folder with rupture's programs: {folder}/load does not"
            " exist. See --help."
        )
    return folder


def check_sweep(words, options):
    if options.from_scratch:
        raise UsageError(
            "--from-scratch is for figures; a sweep starts from what its file says. See --help."
        )
    if len(words) != 2:
        raise UsageError("'sweep' needs one file, as in ./reproduce.sh sweep my.ini. See --help.")


def check_commands(words, options):
    """One command, or several figures."""
    if options.dry_run:
        raise UsageError("--dry-run is for 'sweep' only. See --help.")
    recipes = recipe_names()
    for word in words:
        if word in recipes:
            continue
        if word not in COMMANDS:
            raise UsageError(f"there is no figure or command '{word}'. There are:\n{listing()}")
        if len(words) > 1:
            raise UsageError(
                f"'{word}' cannot be combined with other commands. There are:\n{listing()}"
            )


def request_of(options, caller):
    """`caller`: the folder in which it was typed."""
    if not options.commands:
        raise UsageError("")
    command = options.commands[0] if options.commands[0] in COMMANDS else "recipes"
    check = check_sweep if command == "sweep" else check_commands
    check(options.commands, options)
    return Request(
        command=command,
        recipes=options.commands if command == "recipes" else [],
        file=caller / options.commands[1] if command == "sweep" else None,
        dry_run=options.dry_run,
        from_scratch=options.from_scratch,
        profile=profile_at(options.profile, caller),
        programs=None if options.programs is None else programs_at(options.programs, caller),
        cores=int(options.cores or os.cpu_count() or 1),
    )
