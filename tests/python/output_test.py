"""What map, movie, watch and xdmf have in common: packages that are missing, and files that appear
whole or not at all. What they refuse is in tools/tables/drawing.txt."""

import os
import sys
from pathlib import Path
from unittest import mock

import pytest

import rupture
from commands import refuses
from conftest import BIN, run
from rupture.replacing import replacing
from rupture.tools.command_line import CLEAR, Failure
from rupture.tools.output import EXISTS, complete, progress


@pytest.fixture
def without_h5py(folder):
    """The environment of a machine that lacks it."""
    Path("h5py.py").write_text("raise ModuleNotFoundError(name='h5py')\n")
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), os.environ["PYTHONPATH"]])}


@pytest.mark.parametrize("name", ["map", "movie", "watch", "xdmf"])
def test_packages_that_are_missing_are_named(without_h5py, name):
    sentence = "h5py is not installed; install it, on Debian with apt-get install python3-h5py"
    refuses(f"{name} --help", 1, sentence, env=without_h5py)


def test_the_package_runs_programs_without_h5py(without_h5py):
    run_it = "import rupture, rupture.errors; print(rupture.__version__)"
    for command in (("/usr/bin/python3", "-c", run_it), ("golden", "--version")):
        done = run(*command, env=without_h5py)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr
    with pytest.raises(AttributeError, match="has no attribute 'nix'"):
        getattr(rupture, "nix")


def test_all_streams_may_be_closed(small):
    command = f"{BIN}/xdmf small.h5 -o closed.xdmf <&- >&- 2>&-"
    assert [run("bash", "-c", command).returncode for _ in range(2)] == [1, 1]
    assert Path("closed.xdmf").read_text().startswith("<?xml")


def test_progress_goes_to_a_terminal_alone(capsys):
    for is_terminal in (False, True):
        with mock.patch.object(sys.stderr, "isatty", return_value=is_terminal):
            assert list(progress("ab", 2, "frame")) == ["a", "b"]
        said = f"{CLEAR}frame 1 of 2{CLEAR}frame 2 of 2{CLEAR}" if is_terminal else ""
        assert capsys.readouterr() == ("", said)


def test_a_file_that_appears_meanwhile_is_kept_and_ours_is_deleted(folder):
    with pytest.raises(Failure) as failure, complete("new", False) as temporary:
        temporary.write_text("ours")
        Path("new").write_text("theirs")
    assert [(path.name, path.read_text()) for path in folder.iterdir()] == [("new", "theirs")]
    assert f"{failure.value}" == f"new {EXISTS}"


def test_a_link_is_replaced_and_one_in_the_place_of_the_temporary_file_not_followed(folder):
    Path("theirs").write_text("theirs")
    for name in (".x.tmp.0", "x"):
        Path(name).symlink_to("theirs")
    with mock.patch("secrets.token_hex", return_value="0"):
        with pytest.raises(FileExistsError), replacing("x"):
            pass
    with replacing("x") as temporary:
        temporary.write_text("ours")
    assert Path(".x.tmp.0").is_symlink() and not Path("x").is_symlink()
    assert Path("theirs").read_text() == "theirs"
