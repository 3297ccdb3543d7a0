"""What map, movie, watch and xdmf have in common: packages that are missing, files that are none,
outputs that cannot be written, by their path or because the disk is full. One sentence, and nothing
is left."""

import os
import resource
import sys
from importlib import import_module
from pathlib import Path
from unittest import mock

import pytest

import rupture
from conftest import BIN, run
from program import describes_itself, refuses
from rupture.replacing import rename_to_new, replacing
from rupture.tools.command_line import CLEAR
from rupture.tools.output import progress

WRITERS = {"map": ("small-record.h5", ".png"), "movie": ("small-record.h5", ".gif")}
WRITERS["xdmf"] = ("small.h5", ".xdmf")
PROGRAMS = (*WRITERS, "watch")
writers = pytest.mark.parametrize("name", WRITERS)
programs = pytest.mark.parametrize("name", PROGRAMS)


@programs
def test_describes_itself(name):
    describes_itself(name)


@pytest.fixture
def without_h5py(folder):
    """The environment of a machine that lacks it."""
    Path("h5py.py").write_text("raise ModuleNotFoundError(name='h5py')\n")
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), os.environ["PYTHONPATH"]])}


@programs
def test_packages_that_are_missing_are_named(without_h5py, name):
    env = without_h5py
    sentence = "h5py is not installed; install it, on Debian with apt-get install"
    refuses(name, ("--help",), 1, sentence, env=env)


def test_the_package_runs_programs_without_h5py(without_h5py):
    run_it = "import rupture, rupture.errors; print(rupture.__version__)"
    for command in (("/usr/bin/python3", "-c", run_it), ("golden", "--version")):
        done = run(*command, env=without_h5py)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr
    with pytest.raises(AttributeError, match="has no attribute 'nix'"):
        getattr(rupture, "nix")


@programs
def test_inputs_that_are_no_files_of_rupture(folder, name):
    Path("folder").mkdir()
    Path("empty.h5").touch()
    Path("text.h5").write_text("no HDF5\n")
    Path("short.h5.part").write_text("rupture-record-part\nbytes 9000\n")
    os.mkfifo("pipe")
    sentences = [
        ("", "the name of an input is empty; give the path of a checkpoint or record"),
        ("folder", "folder is a folder; give the path of a checkpoint or record"),
        ("pipe", "pipe is not a regular file; give the path of a checkpoint or record"),
        ("text.h5/x", "text.h5/x does not exist; give the path of a checkpoint or record"),
        ("empty.h5", "empty.h5 is empty; expected a checkpoint or record"),
        ("text.h5", "text.h5 is not a rupture file: give one that rupture's programs wrote"),
        ("short.h5.part", "is truncated: it ends within its 512-byte header; copy it again"),
    ]
    output = ("-o", f"x{WRITERS[name][1]}") if name in WRITERS else ()
    for given, part in sentences if output else sentences[4:]:
        refuses(name, (given, *output), 1, part)


@writers
def test_outputs_that_cannot_be_written(small, name):
    given, ending = WRITERS[name]
    folder = Path(f"folder{ending}")
    folder.mkdir()
    for output, code, part in (
        ("", 2, "the name of an output is empty; give the path of a file"),
        ("-", 2, f"- must end with {ending}"),
        (folder, 1, f"{folder} is a folder; give the path of a file to write"),
        (f"small.h5/x{ending}", 1, "small.h5 is not an existing folder; give another path"),
        (f"/proc/x{ending}", 1, f"cannot write /proc/x{ending}: "),
        (f"{'x' * 300}{ending}", 1, "File name too long"),
    ):
        refuses(name, (given, "-f", "-o", output), code, part)


@writers
def test_outputs_that_are_inputs(small, name):
    given, ending = WRITERS[name]
    own = Path(f"own{ending}")
    own.write_bytes(Path(given).read_bytes())
    sentence = f"{own} is the input, which is never changed: give another output"
    refuses(name, (own, "-o", own, "-f"), 2, sentence)
    assert own.read_bytes() == Path(given).read_bytes()


@writers
def test_outputs_for_which_the_disk_has_no_room(small, name):
    import_module("matplotlib.font_manager")  # writes its cache now, while there is room
    given, ending = WRITERS[name]
    refused = "x-derived.hdf5" if name == "xdmf" else f"x{ending}"
    refuses(
        name,
        (given, "-o", f"x{ending}"),
        1,
        f"cannot write {refused}: File too large",
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)),
    )


@pytest.mark.parametrize(
    "command",
    [f"{name} --{what}" for name in PROGRAMS for what in ("help", "describe")]
    + ["watch --text small-record.h5"],
)
def test_outputs_of_text(small, command):
    reasons = {"/dev/full": "No space left on device", "&-": "Bad file descriptor"}
    for to, reason in reasons.items():
        done = run("bash", "-c", f"{BIN}/{command} >{to}")
        sentence = f"rupture {command.split()[0]}: standard output: {reason}\n"
        assert (done.returncode, done.stderr) == (1, sentence)


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


def test_a_file_that_appears_meanwhile_is_kept(folder):
    Path("theirs").write_text("theirs")
    with pytest.raises(FileExistsError), replacing("new", rename_to_new) as temporary:
        temporary.write_text("ours")
        os.link("theirs", "new")
    assert (Path("new").read_text(), left()) == ("theirs", [])


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
