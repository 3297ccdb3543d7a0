"""Sources in any folder: which commit a build of them states, and that line ends stay."""

import os

import pytest

from conftest import ODD, ROOT, need, run, skip, succeeds

need("git")
PROJECT = f"""cmake_minimum_required(VERSION 3.25)
project(odd VERSION 1.2 LANGUAGES NONE)
include({ROOT}/cmake/Version.cmake)
"""
OURS, OTHERS = "submitted-v2", "submitted-v3"  # tags of our repository, and of another
UNKNOWN = "unknown (the sources are no git repository)"
OF_ANOTHER_USER = "unknown (the git repository belongs to another user)"


def git(folder, *words):
    who = ("-c", "user.name=x", "-c", "user.email=x@x")
    succeeds("git", *who, *words, cwd=folder)


def make_repository(folder, tag):
    folder.mkdir(exist_ok=True)
    git(folder, "init")
    git(folder, "commit", "--allow-empty", "-m", "first")
    git(folder, "tag", "-a", tag, "-m", "a version")


@pytest.mark.parametrize(
    "own, variables, owner, commit",
    [
        (True, {}, 0, OURS),
        (True, {"GIT_DIR": "../.git", "GIT_WORK_TREE": "..", "GIT_INDEX_FILE": "/x"}, 0, OURS),
        (True, {}, 65534, OF_ANOTHER_USER),
        (False, {}, 0, UNKNOWN),
    ],
)
def test_only_the_repository_of_the_sources_names_the_commit(folder, own, variables, owner, commit):
    if owner and os.geteuid() != 0:
        pytest.skip("Only root gives a folder to others.")
    make_repository(folder, OTHERS)
    source = folder / ODD
    source.mkdir()
    if own:
        make_repository(source, OURS)
    (source / "CMakeLists.txt").write_text(PROJECT)
    os.chown(source, owner or os.geteuid(), -1)
    for words in ("-S . -B ../build -G Ninja", "--build ../build --target rupture_version"):
        succeeds("cmake", *words.split(), cwd=source, env=os.environ | variables)
    assert f'text_of_commit[128] = "{commit}";' in (folder / "build/version.cpp").read_text()


def test_a_clone_has_our_line_ends(folder):
    if not (ROOT / ".git").exists():
        skip("These sources are no git repository.")
    git(folder, "-c", "core.autocrlf=true", "clone", "--depth=1", f"file://{ROOT}", "clone")
    assert "  fig3 " in run("bash", "clone/reproduce.sh", "list").stdout
