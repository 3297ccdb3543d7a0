"""The Debian package that cpack makes: its contents, its dependencies, and lintian's opinion."""

import subprocess

import pytest

from conftest import BUILD, need, run

need("dpkg-shlibdeps", "lintian")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("debian")
    output_of("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    [made] = folder.glob("rupture_*_*.deb")
    return made


def test_lintian_finds_no_error(package):
    done = run("lintian", "--allow-root", package)
    assert (done.returncode, done.stdout) == (0, ""), done.stderr


def test_it_depends_on_libraries_and_on_what_recipes_need(package):
    depends = output_of("dpkg-deb", "--field", package, "Depends")
    packages = {each.split()[0] for each in depends.split(", ")}
    assert {"ninja-build", "python3-h5py", "python3-matplotlib", "libc6"} <= packages
    assert "ffmpeg" in output_of("dpkg-deb", "--field", package, "Recommends")
    assert any(each.startswith("libhdf5") for each in packages), packages


def test_what_it_unpacks_is_complete(package, folder):
    output_of("dpkg-deb", "--extract", package, folder)
    assert [path.name for path in (folder / "usr/bin").iterdir()] == ["rupture"]
    assert "  fig3 " in output_of(folder / "usr/bin/rupture", "reproduce", "list")
    for path in (
        "doc/rupture/copyright",
        "doc/rupture/README.md",
        "doc/rupture/CHANGELOG.md",
        "man/man1/rupture.1.gz",
        "rupture/checkpoints/manifest",
        "rupture/benchmarks/lammps/bulk.in",
    ):
        assert (folder / "usr/share" / path).exists(), path
