"""The command line of ./reproduce.sh."""

import argparse
import os
import re
from functools import partial
from pathlib import Path

from rupture.errors import UsageError
from rupture.tools import command_line
from rupture.tools.command_line import suggestion, whole_number
from claims.recipes import read_readme, recipe_names
from rupture.commands.machine import usable_cores
from reproduce.project import BESIDE_ALL, SHARE, WORK

PROGRAM = "rupture reproduce" if WORK else "./reproduce.sh"
PURPOSE = (
    "Computes the figures that you name, or all, and writes them to results/ in the current folder."
    f" {PROGRAM} list lists them."
)
COMMANDS = {
    "all": f"all figures above without a /, except {', '.join(BESIDE_ALL)}; then the report",
    "sweep": "FILE.ini: run the model for all values in the file (docs/sweeps.md)",
    "report": "write results/index.html: all figures and claims on one page",
    "list": "print this list",
    "help": "print the options and this list",
    "clean": "delete what these commands wrote and built, and list what is left",
}
if not WORK:
    COMMANDS |= {
        "test": "build and run the tests",
        "test-slurm": "install SLURM, start it on this machine and test with it (some minutes)",
        "check": "check the sources: formatters, linters, spelling",
    }


def listing():
    titles = {name: read_readme(SHARE / f"recipes/{name}/README.md").title for name in figures()}
    return "\n".join(f"  {name:<11} {title}" for name, title in (titles | COMMANDS).items())


def figures():
    return recipe_names(SHARE)


class Parser(command_line.Parser):
    def __init__(self):
        super().__init__("reproduce COMMAND [options]", PURPOSE, "word", PROGRAM, version)

    def format_help(self):
        return f"{super().format_help()}\nFigures and commands:\n{listing()}\n"

    def description_json(self):
        return super().description_json() | {"words": [*figures(), *COMMANDS], "outputs": []}


def version(_):
    citation = (SHARE / "CITATION.cff").read_text(encoding="utf-8")
    return f"{PROGRAM} (rupture {re.findall('^version: (.*)$', citation, re.MULTILINE)[0]})"


def programs_at(text):
    folder = Path.cwd() / text
    if not text or not os.access(folder / "load", os.X_OK):
        raise argparse.ArgumentTypeError(
            f"the programs are not in '{text}': there is no {folder}/load"
        )
    return folder


def make_parser():
    parser = Parser()
    add = parser.add_argument
    text = "figures, or one of the commands below; behind sweep its file"
    add("words", metavar="COMMAND", nargs="*", help=text)
    text = (
        "compute nothing; print the commands of all points; for a sweep, the number of points and"
        " the commands of the first"
    )
    add("--dry-run", action="store_true", help=text)
    text = "also compute the checkpoints that figures start from, instead of using checkpoints/"
    add("--from-scratch", action="store_true", help=text)
    text = "of clean: delete only results that no figure has asked for the last time"
    add("--unneeded", action="store_true", help=text)
    text = "use the programs in this folder instead of building them"
    add("--programs", type=programs_at, metavar="FOLDER", help=text)
    text = "use N cores of this machine (default: all that may be used)"
    read_cores = partial(whole_number, least=1)
    add("--cores", type=read_cores, metavar="N", help=text)
    return parser


def check_sweep(request):
    if request.from_scratch:
        raise UsageError("--from-scratch is for figures; the file of a sweep says where it starts")
    if len(request.words) != 2:
        raise UsageError(f"'sweep' needs one file, as in {PROGRAM} sweep my.ini")
    request.file = Path(request.words[1]).absolute()


def check_commands(request):
    """One command, or several figures."""
    if request.dry_run and not {*request.words} <= {*figures()}:
        raise UsageError("--dry-run is for figures and for sweep")
    if request.unneeded and request.command != "clean":
        raise UsageError("--unneeded is for clean")
    for word in [one for one in request.words if one not in figures()]:
        if word not in COMMANDS:
            hint = suggestion(word, [*figures(), *COMMANDS]) or f": see {PROGRAM} list"
            raise UsageError(f"there is no figure or command '{word}'{hint}")
        if len(request.words) > 1:
            raise UsageError(f"'{word}' cannot be combined with other commands or figures")


def read(words):
    """The request: options; `command`, of COMMANDS or `recipes`; `words`, the recipes; and `file`
    of a sweep. Paths are absolute."""
    request = make_parser().parse_intermixed_args(words)
    if not request.words:
        return request
    request.command = request.words[0] if request.words[0] in COMMANDS else "recipes"
    request.given, request.cores = request.cores, request.cores or usable_cores()
    (check_sweep if request.command == "sweep" else check_commands)(request)
    return request
