"""Tests of the programs, and checks of the sources: ./reproduce.sh test and check."""

import json
import os
import re
import subprocess
from pathlib import Path

from rupture.errors import Failure
from reproduce.project import LOGS, say, use_own_environment
from reproduce.processes import ensure_packages, set_up

CPP = "find include src tests benchmarks -name '*.[ch]pp' -o -name '*.h' | sort"
SHELL = (
    "reproduce.sh .ci/run src/tools/reproduce src/tools/*/*.sh recipes/*/*.sh packaging/*.sh"
    " recipes/reproduce/slurm/job.sh tests/*/*.sh"
)
PYTHON = "python recipes src tests benchmarks"
TEXTS = f"{PYTHON} README.md CONTRIBUTING.md docs include packaging reproduce.sh"
CPPCHECK = (
    "cppcheck --quiet --std=c++20 --language=c++ --enable=warning,style,performance,portability"
    " --inline-suppr --suppressions-list=.cppcheck --library=googletest --error-exitcode=1"
    " -I include -I src -I src/tools -I tests include src tests benchmarks -j $0"
)
SPELLING = "-q 3 -S '*.h5,*.png,*.ipynb,*/corpus/*' -L coul,crate,kinf,libary,lod,nd,statics,untill"
LAYOUT = {"clang-format": "14", "black": "23"}  # Debian 12's versions: others differ
# In bash; $0 is the number of cores. By Debian's programs: others may demand another layout.
CHECKS = {
    f"{CPP} | xargs /usr/bin/clang-format --dry-run -Werror": "clang-format would change the files"
    " above (clang-format -i FILE).",
    f"/usr/bin/black --check --diff --quiet {PYTHON}": "black would change this (black FILE).",
    f"/usr/bin/flake8 {PYTHON}": "flake8 reported the problems above (.flake8 lists exceptions).",
    "/usr/bin/mypy --no-error-summary": "mypy reported the problems above.",
    f"shellcheck {SHELL}": "shellcheck reported the problems above.",
    "reuse lint --quiet": "Some files have no licence (reuse lint lists them): add it to"
    " .reuse/dep5.",
    CPPCHECK: "cppcheck reported the problems above (.cppcheck lists exceptions).",
    f"codespell {SPELLING} {TEXTS}": "codespell reported the typos above.",
    "PYTHONPATH=recipes:python /usr/bin/python3 -m claims.freeze > /dev/null": "What decides a"
    " verdict is not as it was frozen (docs/frozen.md).",
    f"! grep -rnif .phrases {TEXTS}": "The lines above are not plain English (.phrases).",
}


def run_ctest(processes, preset, log, cores):
    use_own_environment()
    log.unlink(missing_ok=True)
    command = f"ctest --preset {preset} --parallel {cores} --no-tests=error --output-log"
    return processes.run([*command.split(), log.absolute()])


def run_tests(request, processes):
    set_up(processes, "build", request.cores, "all", "run", "test")
    return run_ctest(processes, "release", LOGS / "test.log", request.cores)


def test_slurm(request, processes):
    """If SLURM cannot be installed, ctest reports that these tests were skipped."""
    set_up(processes, "build", request.cores, "tools", "run")
    try:
        ensure_packages(processes, "slurm")
    except SystemExit:
        if processes.received:
            raise
        say("Continuing without them.")
    return run_ctest(processes, "slurm", LOGS / "slurm.log", 1)


def defines_layout(program):
    """Whether this version defines the layout. Another one is an error only in CI."""
    said = subprocess.run([program, "--version"], capture_output=True, check=True, text=True).stdout
    version, name = re.findall(r"\d+", said)[0], Path(program).name
    if version != LAYOUT[name]:
        sentence = (
            f"Layout not checked: it needs {name} {LAYOUT[name]}, but {version} is installed."
        )
        if os.environ.get("CI"):
            raise Failure(sentence)
        say(sentence)
    return version == LAYOUT[name]


def compile_commands():
    """One command per C++ file and header; a header that a source includes first is left out, and
    so are tests, which nobody includes."""
    first = re.compile(r'#include ["<](.+)[">]')
    sources = [path for one in ("src", "benchmarks") for path in Path(one).rglob("*.cpp")]
    found = [first.search(path.read_text()) for path in sources]
    included = tuple(f"/{each[1]}" for each in found if each)
    tests = Path("tests").resolve()
    for entry in json.loads(Path("build/check/compile_commands.json").read_text()):
        path = Path(entry["file"])
        if path.exists() and tests not in path.parents and not str(path).endswith(included):
            check = " -fsyntax-only -fdelayed-template-parsing "
            yield re.sub(" -o .*", check, entry["command"]) + str(path)


def compile_each_alone(request, processes):
    """Compiles each file alone: precompiled headers and groups of files hide a missing #include."""
    set_up(processes, "configure", "check")
    commands = Path("build/check/commands")
    commands.write_text("\n".join(compile_commands()))
    each = f"xargs -P {request.cores} -d \\n -n 1 -a {commands} sh -c"
    if processes.run(each.split()):
        raise Failure("The files above do not compile on their own.")


def check_sources(request, processes):
    """Runs cppcheck, which takes seconds without the headers of libraries; the compiler sees
    those."""
    ensure_packages(processes, "build", "run", "check")
    for command, sentence in CHECKS.items():
        layout = re.search("/usr/bin/(clang-format|black) ", command)
        if layout and not defines_layout(layout[0].strip()):
            continue
        if processes.run(["bash", "-c", command, str(request.cores)]):
            raise Failure(sentence)
    compile_each_alone(request, processes)
    say("No problems were found in the sources.")
