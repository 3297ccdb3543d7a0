"""The commands in the recipes' READMEs are those that recipes run.

A command by hand has the program, the options and the values of one of a recipe. It may leave out
what only concerns files, and what is a default."""

import importlib
import inspect
import json
import re
import shlex
from contextlib import suppress
from pathlib import Path

from pytest import MonkeyPatch, fixture, mark
from rupture import once
from rupture.commands.making import Making


import maps
from claims.recipes import read_readme, recipe_names
from claims.samples import Sampling
from conftest import ROOT, run

PROGRAMS = ("load", "prepare", "restart", "modify-phi", "analyze")
FILES = ("--force", "--quiet", "--json", "-o", "--record", "--record-every")
# A recipe may also ask for checkpoints and crossings for later steps, name the only event of a
# record, and measure in other ways, too.
UNSAID = ("--event", "--checkpoint-every", "--checkpoint-at", "--crossings", "--also")
# Seeds and places follow from recipes/frozen.toml. By hand there may be others, or no seed.
FROZEN = ("--tau-bar", "--sigma-bar", "--seed", SEED := "--numerics.seed")
# Commands that no recipe runs: functions read these records, or call the program, themselves.
ONLY_BY_HAND = (
    *("analyze loading --x", "analyze events", "analyze events --slow-below"),
    "analyze slip --x --to",
)
# {option: value} of what `load` and `prepare` start from.
PARAMETERS = json.loads(run("parameters", "--json").stdout)["parameters"]
DEFAULTS = {f"--{row['name']}": str(row["default"]) for row in PARAMETERS} | {"--sigma-bar": "0"}


class Anything(dict):
    """Whatever a report has, and what is calculated with it: `$` in a command."""

    def it(self, *_):
        return self

    __getattr__ = __getitem__ = __round__ = __or__ = __ror__ = it
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = it

    def so(self, _):
        return True

    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = so

    def not_so(self, _):
        return False

    __ne__ = not_so
    __hash__ = object.__hash__  # type: ignore[assignment]

    def __bool__(self):
        return True

    def __iter__(self):
        return iter([self])

    def __format__(self, _):
        return "$"


def report(_, work):
    also = re.search("--also '(.*?)'", work.line)
    return [Anything()] * (2 + also[1].count(";")) if also else Anything()


def ask_all():
    """Calls all functions of recipes that need nothing. Nobody reads what they calculate."""
    for path in sorted((ROOT / "recipes").glob("*/*.py")):
        if (path.parent / "commands.py").exists():
            module = importlib.import_module(f"{path.parent.name}.{path.stem}")
            for function in [*vars(module).values()]:
                is_own = getattr(function, "__module__", "") == module.__name__
                is_function = inspect.isfunction(inspect.unwrap(function)) if is_own else False
                if is_function and not inspect.signature(function).parameters:
                    with suppress(Exception):
                        function()


def lines_of_recipes(folder):
    with MonkeyPatch.context() as patch:
        patch.setattr(Making, "report", report)
        patch.setattr(maps.Interfaces, "edge", lambda self, *_: self.kinds(1))
        patch.setattr(Sampling, "is_whole", True)
        patch.setattr("shutil.which", lambda name: name)  # LAMMPS
        works = once.use(store=folder, cores=1).works
        ask_all()
        lines = {work.line for work in works.values()}
        once.finish()
    return lines


def calls_in(text):
    """Words of each call of a program, without files. A part that the shell computes is `$`,
    and so is a list with semicolons."""
    text = re.sub(r"^PYTHONPATH=.*", "", text.replace("\\\n", " "), flags=re.MULTILINE)  # Python
    text = re.sub(r'\$\((?:[^()]|\([^()]*\)|\(\([^()]*\)\))*\)|\$\w+|"[^"]*;[^"]*"', "$", text)
    for part in re.split(r"[;\n]|&&|\|\|", text):
        words = shlex.split(re.sub(r"\d?>.*", "", part).replace("{", " ").replace("(", " "))
        words = [word for word in words if word not in ("do", "rupture") and word[-3:] != ".h5"]
        if words and Path(words[0]).name in PROGRAMS:
            yield [Path(words[0]).name, *words[1:]]


def parse(words):
    """The program and what it analyzes; {option: values}, parameters among them. A restart goes on
    with what the checkpoint has, whatever the defaults are."""
    text = re.sub(r" --set (\S+?)=", r" --\1 ", " ".join(words))
    program = re.findall(r"^(?:analyze )?\S+", text)[0]
    found = re.findall(r" (--?[a-z]\S*)((?: (?!--?[a-z])\S+)*)", text)
    options = {name: values.split() for name, values in found if name not in FILES}
    known = DEFAULTS if program in ("load", "prepare") else {}
    return program, {
        name: values
        for name, values in options.items()
        if name not in known or not same(values[0], known[name])
    }


def same(value, other):
    if "$" in other:
        return True
    try:
        return abs(float(value) - float(other)) <= 1e-9 * abs(float(other))
    except ValueError:
        return value == other


def fits(program, name, values, others):
    """A load by hand may end earlier: it is the beginning of the other."""
    if name in FROZEN:
        return len(values) == len(others) == 1
    if program == "load" and name == "--until":
        return same(values[0], others[0]) or float(values[0]) <= float(others[0])
    return len(values) == len(others) and all(map(same, values, others))


def matches(call, other):
    (program, options), (program_of_chain, options_of_chain) = call, other
    return (
        program == program_of_chain
        and options_of_chain.keys() - {*UNSAID, SEED} <= options.keys() <= options_of_chain.keys()
        and all(fits(program, name, options[name], options_of_chain[name]) for name in options)
    )


@fixture(scope="module", name="calls")
def all_calls(tmp_path_factory):
    lines = lines_of_recipes(tmp_path_factory.mktemp("store") / "store")
    found = [
        parse(words) for line in lines for words in calls_in(re.sub("'[^']*;[^']*'", "$", line))
    ]
    return list({repr(call): call for call in found}.values())


@mark.parametrize("name", recipe_names(ROOT))
def test_each_command_by_hand_is_one_of_a_recipe(name, calls):
    pages = (ROOT / "recipes" / name).glob("*.md")
    chain = [words for page in pages for words in calls_in(read_readme(page).commands)]
    assert len(chain) > 1
    for words in chain:
        program, options = call = parse(words)
        only_by_hand = " ".join([program, *options]) in ONLY_BY_HAND
        assert only_by_hand or any(matches(call, other) for other in calls), " ".join(words)


@mark.parametrize(
    "text",
    [
        "restart a.h5 -o b.h5 --for 0.01 --set driving.V=1",
        "analyze front a.h5 --stencil 7",
        "prepare -o a.h5 --tau-bar 0.1 --shape bell --no-trigger",
        "analyze slip a.h5",
    ],
)
def test_a_command_with_another_value_or_option_is_none(text, calls):
    (words,) = calls_in(text)
    assert not any(matches(parse(words), other) for other in calls)
