"""The Debian package that cpack makes: its contents, its dependencies, and lintian's opinion."""

import pytest

from conftest import BUILD, need, succeeds

need("dpkg-shlibdeps", "lintian")


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("debian")
    succeeds("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    [made] = folder.glob("rupture_*_*.deb")
    return made


def test_lintian_finds_no_error(package):
    assert succeeds("lintian", "--allow-root", package).stdout == ""


def test_it_depends_on_libraries_and_on_what_recipes_need(package):
    fields = succeeds("dpkg-deb", "--field", package).stdout
    depends = fields.partition("\nDepends: ")[2].partition("\n")[0]
    packages = {each.split()[0] for each in depends.split(", ")}
    assert {"python3-h5py", "python3-matplotlib", "libc6"} <= packages
    assert "ninja-build" not in packages, "it compiles only"
    assert "\nRecommends: ffmpeg" in fields
    assert any(each.startswith("libhdf5") for each in packages), packages


def test_what_it_unpacks_works(package, folder):
    succeeds("dpkg-deb", "--extract", package, folder)
    assert [path.name for path in (folder / "usr/bin").iterdir()] == ["rupture"]
    assert "  fig3 " in succeeds(folder / "usr/bin/rupture", "reproduce", "list").stdout
    if any(BUILD.glob("bin/rupture_simulation.*")):
        code = "import rupture; print(rupture.Simulation.from_parameters().time)"
        environment = {"PYTHONPATH": str(folder / "usr/lib/python3/dist-packages")}
        assert succeeds("/usr/bin/python3", "-c", code, env=environment).stdout == "0.0\n"
