"""The installed CMake package, as the project of a user (project/) uses it."""

import os
import re
import shutil
from pathlib import Path

import pytest

from conftest import BUILD, ODD, ROOT, run, succeeds

LISTS = Path("project/CMakeLists.txt")
WITHOUT_FMT = "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON"


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    prefix = tmp_path_factory.mktemp("installed") / ODD
    succeeds("cmake", "--install", BUILD, "--prefix", prefix)
    return prefix


@pytest.fixture
def configuring(prefix, folder):
    """The command that configures project/ in build/."""
    shutil.copytree(ROOT / "tests/regression/project", folder / "project")
    return (*"cmake -S project -B build -G Ninja".split(), f"-DCMAKE_PREFIX_PATH={prefix}")


def built(*target):
    return succeeds("cmake", "--build", "build", *target).stdout


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_a_test_of_ones_own_notices_that_results_changed(prefix, folder, monkeypatch):
    """That of docs/regression-tests.md."""
    monkeypatch.setenv("PATH", f"{prefix}/bin:{os.environ['PATH']}")
    page = (ROOT / "docs/regression-tests.md").read_text(encoding="utf-8")
    (script,) = re.findall("```bash\n(.*?)```", page, re.DOTALL)
    Path("my_test.sh").write_text(script, encoding="utf-8")
    for option in (("accept",), ()):
        assert succeeds("bash", "my_test.sh", *option).stdout.endswith("\n3 intact\n")

    replace(Path("my_test.sh"), "sigma-bar 0.15", "sigma-bar 0.16")
    said = run("bash", "my_test.sh")
    assert said.returncode == 1
    assert "changed  event-record.h5 is intact but has content checksum" in said.stdout
    assert "\n3 changed\n" in said.stdout


@pytest.mark.parametrize("where", [BUILD / "bin", None])
def test_programs_look_for_libraries_only_where_the_system_does(where, prefix):
    folder = where or prefix / "libexec/rupture"
    programs = [path for path in folder.iterdir() if path.read_bytes()[:4] == b"\x7fELF"]
    assert programs
    for program in programs:
        assert "PATH)" not in succeeds("readelf", "--dynamic", program).stdout


def test_rupture_finds_its_tools_and_recipes_and_writes_where_it_is_called(prefix, folder):
    work, rupture = folder / f"work in {ODD}", prefix / "bin/rupture"
    work.mkdir()
    assert [path.name for path in rupture.parent.iterdir()] == ["rupture"]
    assert "0 steps" in succeeds(rupture, "load", "-o", work / "a.h5").stdout
    share = prefix / "share"
    documents = {path.name for path in (share / "doc/rupture").iterdir()}
    assert {"README.md", "CHANGELOG.md", "copyright"} <= documents
    assert (share / "rupture/checkpoints/manifest").exists()
    assert (share / "rupture/benchmarks/lammps/bulk.in").exists()
    other = prefix.parent / "python/rupture/__init__.py"  # as beside a clone's src/
    other.parent.mkdir(parents=True)
    for name in ("__init__", "json", "numpy", "sitecustomize"):
        other.with_name(f"{name}.py").write_text("raise RuntimeError\n")
    assert "usage:" in succeeds(rupture, "map", "--help", cwd=other.parent).stdout
    listing = succeeds(rupture, "reproduce", "list").stdout
    assert "test-slurm" not in succeeds(rupture, "reproduce", "--help").stdout
    before = sorted(prefix.rglob("*"))
    succeeds(rupture, "reproduce", "figS1", "figS3", cwd=work)
    for name in ("figS1", "figS3"):
        assert (work / f"results/{name}/claims.json").exists()
    assert sorted(prefix.rglob("*")) == before
    names = re.findall(r"^  (\S+)", listing, re.MULTILINE)
    figures = names[: names.index("all")]
    assert len(figures) >= 17
    said = succeeds(rupture, "reproduce", *figures, "--dry-run", cwd=work).stdout
    assert said.count("\nrupture restart ") > 20  # no chain leads nowhere
    refused = run(rupture, "reproduce", "test")
    assert refused.returncode == 2
    assert "there is no figure or command 'test'" in refused.stderr


def test_a_project_in_cpp_has_the_library_without_asking(configuring):
    page = (ROOT / "docs/library.md").read_text(encoding="utf-8")
    program = "".join(re.findall("```cpp\n(.*?)```", page, re.DOTALL))
    Path("project/my_program.cpp").write_text(program, encoding="utf-8")
    succeeds(*configuring)
    built("--target", "my_program")
    record = ROOT / "tests/compatibility/schema-3/reference-record.h5"
    start = ROOT / "checkpoints/fast-only.h5"
    said = succeeds("build/my_program", start, "stopped.h5", record).stdout
    assert (said.count(" N\n"), said.count("unfinished\n")) == (11, 1)
    assert re.search(r"driving.V +0 m/s", succeeds("analyze", "show", "stopped.h5").stdout)


def test_any_version_of_eigen_is_taken(configuring, folder):
    """By ours and by our users' projects: a version asked for excludes the next major one."""
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    [installed] = re.findall("^Eigen3_DIR:PATH=(.*)$", cache, re.MULTILINE)
    Path("Eigen3Config.cmake").write_text(f'include("{installed}/Eigen3Config.cmake")\n')
    Path("Eigen3ConfigVersion.cmake").write_text("set(PACKAGE_VERSION 5.0)\n")
    options = (f"-DEigen3_DIR={folder}", f"-DCMAKE_IGNORE_PATH={installed}")
    for source in ("project", ROOT):
        shutil.rmtree("build", ignore_errors=True)
        succeeds(*configuring, "-S", source, "-DRUPTURE_TESTS=OFF", *options)


@pytest.mark.parametrize(
    "component, options, sentence",
    [
        ("COMPONENTS libary", [], "libary"),
        ("COMPONENTS library", [WITHOUT_FMT], "find_package for module fmt"),
    ],
)
def test_what_is_wrong_or_missing_is_named(configuring, component, options, sentence):
    replace(LISTS, "rupture REQUIRED", f"rupture REQUIRED {component}")
    refused = run(*configuring, *options)
    assert refused.returncode
    assert sentence in " ".join((refused.stdout + refused.stderr).split())
