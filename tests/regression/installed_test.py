"""The installed CMake package, as the project of a user (project/) uses it."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from conftest import BUILD, ODD, ROOT, run, succeeds

OF_TOOLS = """\
cmake_minimum_required(VERSION 3.25)
project(mine LANGUAGES {})
enable_testing()
find_package(rupture REQUIRED)
rupture_add_checkpoint_test(NAME mine PIPELINE my_pipeline.sh GOLDEN mine.sums)
"""
LISTS = Path("project/CMakeLists.txt")
WITHOUT_FMT = "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON"
GOLDENS = ("--target", "rupture_regenerate_goldens")
NEEDS_FMT = "it needs fmt, which cannot be found"


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


def tested():
    return run("ctest", "--test-dir", "build", "--output-on-failure").stdout


def built(*target):
    return succeeds("cmake", "--build", "build", *target).stdout


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_a_project_notices_that_its_results_changed(configuring, prefix, folder):
    succeeds(*configuring)
    built()
    assert "there is no golden file" in tested()

    built(*GOLDENS)
    assert "100% tests passed, 0 tests failed out of 2" in tested()
    before = Path("project/my_pipeline.sums").read_bytes()

    replace(Path("project/my_slider.ini"), "N_s = 37", "N_s = 38")
    said = tested()
    assert "50% tests passed, 1 tests failed out of 2" in said
    for name in ("event-record.h5", "event.h5"):
        assert f"differs  {name} is intact but has content checksum" in said
    assert "\n3 differs\n" in said
    analyze = shlex.quote(f"{prefix}/libexec/rupture/analyze")
    assert f"{analyze} diff {folder}/build/my_pipeline.files/equal" in said

    assert "my_program.sums is current" in built(*GOLDENS)
    assert "100% tests passed" in tested()
    assert Path("project/my_pipeline.sums.old1").read_bytes() == before


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
    assert "tidy" not in succeeds(rupture, "reproduce", "--help").stdout
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


@pytest.mark.parametrize(
    "language, options, says", [("NONE", [], ""), ("CXX", [WITHOUT_FMT], NEEDS_FMT)]
)
def test_a_project_needs_no_more_than_the_tools(configuring, language, options, says):
    LISTS.write_text(OF_TOOLS.format(language))
    assert says in succeeds(*configuring, *options).stdout
    built(*GOLDENS)
    assert "100% tests passed, 0 tests failed out of 1" in tested()


def test_a_project_in_cpp_has_the_library_without_asking(configuring):
    replace(LISTS, " COMPONENTS library", "")
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
    "old, new, options, sentence",
    [
        ("GOLDEN my_pipeline.sums", "", [], "GOLDEN is missing"),
        ("NAME my_pipeline", "twice NAME my_pipeline", [], "'twice' is neither NAME"),
        ("COMPONENTS library", "COMPONENTS libary", [], "libary"),
        ("COMPONENTS library", "COMPONENTS library", [WITHOUT_FMT], NEEDS_FMT),
    ],
)
def test_what_is_wrong_or_missing_is_named(configuring, old, new, options, sentence):
    replace(LISTS, old, new)
    refused = run(*configuring, *options)
    assert refused.returncode
    assert sentence in " ".join(refused.stderr.split())
