"""What map, movie, watch and xdmf have in common: packages that are missing, and files that appear
whole or not at all. What they refuse is in tools/tables/drawing.txt."""

import errno
import os
import sys
from pathlib import Path
from unittest import mock

import pytest

import rupture
from commands import refuses
from conftest import BIN, run
from rupture.replacing import rename_to_new, replacing
from rupture.tools import xdmf
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


def left():
    return [path for path in Path().iterdir() if ".tmp." in path.name]


def test_a_file_that_appears_meanwhile_is_kept_as_ours_is(folder):
    with pytest.raises(Failure) as failure, complete("new", False) as temporary:
        temporary.write_text("ours")
        Path("new").write_text("theirs")
    assert (Path("new").read_text(), temporary.read_text()) == ("theirs", "ours")
    assert f"{failure.value}" == f"new {EXISTS}; the result is kept as {temporary}"


def test_a_disk_may_lack_exclusive_renaming_and_links(folder):
    lacking = mock.patch("ctypes.CDLL"), mock.patch("os.link", side_effect=PermissionError)
    with lacking[0], lacking[1], replacing("new", rename_to_new) as temporary:
        temporary.write_text("ours")
    assert (Path("new").read_text(), left()) == ("ours", [])


@pytest.mark.parametrize("before", ["old", None])
def test_both_files_of_xdmf_appear_or_neither(folder, before):
    both = [Path("x.xdmf"), Path("x-derived.hdf5")]
    renamed: list = []
    for path in both if before else ():
        path.write_text(before)

    def only_once(*names, rename=os.rename):
        if renamed:
            raise OSError(errno.EIO, "")
        renamed.append(rename(*names))

    with mock.patch("os.replace", only_once), pytest.raises(Failure, match="is as it was before"):
        xdmf.write_all([], both[0], both[1], force=True)
    assert [path.read_text() if path.exists() else None for path in both] == [before] * 2


def test_a_signal_while_the_temporary_file_is_made_leaves_nothing(folder):
    program = """from rupture.replacing import *
signal.signal(signal.SIGTERM, end_by_signal)
make = os.open
os.open = lambda *words: (make(*words), os.kill(os.getpid(), signal.SIGTERM))[0]
replacing("x").__enter__()"""
    assert (run("/usr/bin/python3", "-c", program).returncode, left()) == (-15, [])


def test_a_link_in_the_place_of_the_temporary_file_is_neither_followed_nor_deleted(folder):
    Path("theirs").write_text("theirs")
    with mock.patch("secrets.token_hex", return_value="0"):
        Path(".x.tmp.0").symlink_to("theirs")
        with pytest.raises(FileExistsError), replacing("x"):
            pass
        Path(".x.tmp.0").unlink()
        with pytest.raises(OSError), replacing("x") as temporary:
            temporary.rename("x")
            temporary.symlink_to("theirs")
    assert [path.readlink() for path in left()] == [Path("theirs")]
    assert Path("theirs").read_text() == "theirs"


def test_file_and_folder_are_synced(folder):
    synced = []

    def note(file):
        synced.append((os.readlink(f"/proc/self/fd/{file}"), Path("y").exists()))

    with mock.patch("os.fsync", note), replacing("y") as hidden:
        pass
    assert synced == [(f"{folder}/{hidden}", False), (str(folder), True)]


@pytest.mark.parametrize("name, number", [("open", errno.EACCES), ("fsync", errno.EINVAL)])
def test_a_folder_may_forbid_reading_or_syncing(folder, name, number):
    call = getattr(os, name)

    def refuse_folders(place, *more):
        if os.path.isdir(place):
            raise OSError(number, os.strerror(number))
        return call(place, *more)

    with mock.patch.object(os, name, refuse_folders), replacing("y") as hidden:
        hidden.write_text("y")
    assert Path("y").read_text() == "y"
