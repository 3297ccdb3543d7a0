"""./reproduce.sh installs packages and builds, with stand-ins for apt-get and cmake
(recipes/reproduce/set-up.sh)."""

import os
import re
import tempfile
from pathlib import Path

import pytest

from conftest import SHARED, succeeds
from stand_ins import SWEEP, Project

NOBODY = 65534
SET_UP = "recipes/reproduce/set-up.sh"
AS_ROOT = pytest.mark.skipif(os.geteuid() != 0, reason="installs packages, if only by stand-ins")
MISSING = "[[ $* != *--simulate* ]] || { echo Inst x; exit; }\n"
WAIT = "for i in {{1..100}}; do [[ -e {0} ]] && break; sleep 0.1; done; [[ -e {0} ]] || exit 1\n"


@pytest.fixture(name="project")
def copied_project():
    with tempfile.TemporaryDirectory(dir=SHARED) as folder:
        yield Project(Path(folder))


def set_up(project, *words, **options):
    return project.call(SET_UP, *words, command="bash", **options)


def make_cmake(project, says):
    """Notes its calls."""
    text = f"case \"$*\" in *--build*) printf '%b' '{says}';; esac"
    project.program("cmake", f'echo "$*" >> calls\n{text}')


def test_figures_and_sweeps_build_the_programs_only(project):
    make_cmake(project, "ninja: no work to do.\\n")
    project.write("my.ini", SWEEP)
    project.call("sweep", "my.ini", "--dry-run")
    assert re.findall(r"--target (\S+)", project.calls()) == ["tools"]


def test_building_is_said_when_something_is_built(project):
    project.write("build/release/build.ninja")
    make_cmake(project, "[0/1] Re-checking globbed directories...\\nninja: no work to do.\\n")
    assert set_up(project, "build", "2", "tools").stdout == ""
    make_cmake(project, "[1/2] Building CXX object x.o\\n[2/2] Linking CXX executable x\\n")
    said = set_up(project, "build", "2", "tools").stdout
    assert said == "Building (log: build/log/build.log) ...\n"


def test_a_first_build_is_said_at_once(project):
    project.program("cmake", WAIT.format("said"))
    with project.start(SET_UP, "build", "2", "tools", command="bash") as started:
        assert next(iter(started.stdout or ()), "").startswith("Building")
        project.write("said")
    assert started.returncode == 0


def test_configures_if_the_presets_are_newer_or_the_build_is_of_other_sources(project):
    make_cmake(project, "")
    presets = project.write("CMakePresets.json")
    ninja = project.write("build/release/build.ninja")
    for path, home in ((presets, ""), (ninja, project.root), (presets, "."), (ninja, "/elsewhere")):
        project.write("build/release/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={home}\n")
        path.touch()
        set_up(project, "build", "2", "tools")
    configured = [call for call in project.calls().splitlines() if "--build" not in call]
    assert ["--fresh" in call for call in configured] == [True, False, True]


def test_a_failed_build_shows_its_end(project):
    project.program("cmake", "echo error: x\n! [ $1 = --build ]")
    project.write("build/release/build.ninja")
    done = set_up(project, "build", "2", "tools")
    assert (done.returncode, done.stdout) == (1, "")
    end = "error: x\nreproduce.sh: The build failed; the whole output is in"
    assert end in done.stderr


def test_nothing_is_installed_if_nothing_is_missing(project):
    project.program("apt-get", 'echo "$*" >> calls; echo 0 newly installed')
    done = set_up(project, "packages", "bench")
    assert (done.returncode, done.stdout) == (0, "")
    assert re.fullmatch(r"-o \S+ satisfy .* --simulate lammps\n", project.calls())


@AS_ROOT
def test_other_programs_that_install_are_waited_for(project):
    project.program(
        "apt-get",
        f'{MISSING}echo "$*" >> calls; [[ $* != update || $(wc -l < calls) -gt 1 ]] || {{\n'
        "  echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held' >&2; exit 100; }",
    )
    done = set_up(project, "packages", "bench")
    assert done.returncode == 0, done.stderr
    satisfy = r"-o DPkg::Lock::Timeout=\d+ satisfy --no-remove --no-install-recommends -y lammps"
    assert re.fullmatch(f"update\nupdate\n{satisfy}\n", project.calls())


@AS_ROOT
@pytest.mark.parametrize(
    "command, purpose", [("fig3", "run"), ("check", "check"), ("test-slurm", "slurm")]
)
def test_who_is_not_root_hears_of_all_packages_at_once(project, command, purpose):
    project.program("apt-get", MISSING)
    succeeds("chmod", "-R", "a+rwX", project.root)
    done = set_up(project, "python", "--cores", "1", command, user=NOBODY)
    assert (done.returncode, done.stdout) == (1, "")
    [named] = re.findall(
        "^sudo apt-get satisfy --no-remove --no-install-recommends '(.*)'$", done.stderr, re.M
    )
    table = (project.root / "packages.txt").read_text(encoding="utf-8")
    rows = re.findall(rf"^(?:build|run|{purpose}) +([^#\n]*[^#\s])", table, re.M)
    assert named == ", ".join(rows)


@AS_ROOT
def test_what_is_needed_is_installed_before_it_is_built(project):
    project.program("apt-get", f"{MISSING}[[ $* == *satisfy* ]] && echo packages >> calls; exit 0")
    project.program("cmake", "echo cmake >> calls")
    done = set_up(project, "build", "2", "tools", "run")
    assert done.returncode == 0, done.stderr
    assert [*dict.fromkeys(project.calls().split())] == ["packages", "cmake"]


@AS_ROOT
def test_other_failures_of_apt_get_are_final(project):
    project.program("apt-get", "echo 'E: no network' >&2; exit 100")
    done = set_up(project, "packages", "bench")
    assert done.returncode == 1
    assert "no network\nreproduce.sh: Installing packages failed" in done.stderr
