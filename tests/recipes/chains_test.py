"""The chains of commands in the recipes' READMEs are those that the rules run.

A command by hand has the program, the options and the values of one that Snakemake would run, or
that a point of a sweep or chain runs. It may leave out what only concerns files, and what is a
default."""

import json
import os
import re
import shlex
import sys
from pathlib import Path

from pytest import fixture, mark

from chains.points import Chains
from conftest import ROOT, need_modules, run
from runs.recipes import read_readme
from sweeps.sweep import read_sweep

need_modules("snakemake")
PROGRAMS = ("load", "prepare", "restart", "modify-phi", "analyze")
FILES = ("--force", "--quiet", "--sum", "--json", "-o", "--record", "--record-every")
# A rule may also ask for checkpoints and crossings for later steps, and name the only event of a
# record.
UNSAID = ("--event", "--checkpoint-every", "--checkpoint-at", "--crossings")
# Commands that no rule runs: scripts read these records, or call the program, themselves.
ONLY_BY_HAND = (
    *("analyze loading --x", "analyze events", "analyze events --slow-below"),
    "analyze slip --x --to",
)
# {option: value} of what `load` and `prepare` start from.
PARAMETERS = json.loads(run("analyze", "quantities", "--json").stdout)["parameters"]
DEFAULTS = {f"--{row['name']}": str(row["default"]) for row in PARAMETERS} | {"--sigma-bar": "0"}
RULES = sorted(path.parent.name for path in (ROOT / "recipes").glob("*/rules.smk"))
CHAINS = sorted(path.parent.name for path in (ROOT / "recipes").glob("*/figure.ini"))


def planned(folder):
    """All commands of all recipes from scratch, in which events have been found."""
    for name in ("recipes", "python", "checkpoints", "docs", "benchmarks"):
        (folder / name).symlink_to(ROOT / name)
    done = run(
        *(sys.executable, "-m", "snakemake", "--snakefile", "recipes/Snakefile"),
        *(*RULES, "--dryrun", "--forceall", "--printshellcmds", "--cores", "1", "--nolock"),
        *("--log-handler-script", "recipes/common/runs/progress.py"),
        *("--config", "bin=bin", "code=none", "from_scratch=1"),
        cwd=folder,
        env=os.environ
        | {"XDG_CACHE_HOME": str(folder), "PYTHONPATH": "recipes/common:recipes:python"},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    lines = (folder / "build/log/recipes.log").read_text().splitlines()
    return [line.split(maxsplit=2)[2] for line in lines]  # behind the time


def of_sweeps():
    """Without those whose table of points is made by rules, which are like the other ones."""
    for path in sorted((ROOT / "recipes").glob("*/*.ini")):
        if path.parent.name in RULES and "\npoints" not in path.read_text():
            for point in read_sweep(path).points:
                yield from point.commands.values()


def of_chains():
    chains = Chains()
    for path in sorted((ROOT / "recipes").glob("*/*.ini")):
        if path.parent.name in CHAINS and path.name != "figure.ini":
            for point in chains.points(chains.load(path)):
                yield from point.commands.values()


def calls_in(text):
    """Words of each call of a program, without files. A part that the shell computes is `$`,
    and so is a list with semicolons."""
    text = text.replace("\\\n", " ")
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
    if program == "load" and name == "--until":
        return float(values[0]) <= float(others[0])
    return len(values) == len(others) and all(map(same, values, others))


def matches(call, other):
    (program, options), (program_of_rule, options_of_rule) = call, other
    return (
        program == program_of_rule
        and options_of_rule.keys() - set(UNSAID) <= options.keys() <= options_of_rule.keys()
        and all(fits(program, name, options[name], options_of_rule[name]) for name in options)
    )


@mark.parametrize("rule", ["events", "continued"])
def test_rules_whose_results_take_long_list_what_changes_these(rule):
    """The other rules depend on all that scripts share."""
    rules = (ROOT / "recipes/common/runs/ensemble.smk").read_text()
    inputs = re.findall(rf"^rule {rule}:(.*?)    output:", rules, re.MULTILINE | re.DOTALL)[0]
    listed = {*re.findall(r'(\w+)(?:\.py|")', inputs)}
    scripts = [*ROOT.glob("recipes/ensemble/*.py"), *ROOT.glob("recipes/common/events/*.py")]
    texts = [path.read_text() for path in scripts if path.stem in listed]
    used = {*re.findall(r"^from events\.(\w+)", "\n".join(texts), re.MULTILINE)}
    assert "fronts" in used and used - listed <= {"front_claims"}  # for other rules


@fixture(scope="module", name="calls")
def all_calls(tmp_path_factory):
    texts = [*planned(tmp_path_factory.mktemp("plan")), *of_sweeps(), *of_chains()]
    found = [parse(words) for text in texts for words in calls_in(text)]
    return list({repr(call): call for call in found}.values())


@mark.parametrize("name", [*RULES, *CHAINS])
def test_each_command_by_hand_is_one_of_the_rules(name, calls):
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
        "restart a.h5 -o b.h5 --for 0.011 --record c.h5 --record-every 1e-5",
        "restart a.h5 -o b.h5 --for 0.01 --set driving.V=1",
        "analyze front a.h5 --stencil 7",
        "load -o a.h5 --until 1.3",
        "analyze slip a.h5",
    ],
)
def test_a_command_with_another_value_or_option_is_none(text, calls):
    (words,) = calls_in(text)
    assert not any(matches(parse(words), other) for other in calls)
