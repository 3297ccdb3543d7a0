"""What map, movie, watch and xdmf have in common: packages that are missing, files that are none,
outputs that cannot be written, by their path or because the disk is full. One sentence, and nothing
is left."""

import os
import resource
import subprocess
import unittest
from importlib import import_module
from pathlib import Path
from unittest import mock

import small
from program import check_refusals
from rupture.replacing import rename_to_new, replacing

WRITERS = {"map": ("small-record.h5", ".png"), "movie": ("small-record.h5", ".gif")}
WRITERS["xdmf"] = ("small.h5", ".xdmf")


def no_room():
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))


class Packages(unittest.TestCase):
    def test_that_are_missing_are_named(self):
        small.folder()
        Path("h5py.py").write_text("raise ModuleNotFoundError(name='h5py')\n")
        path = os.pathsep.join([os.getcwd(), os.environ["PYTHONPATH"]])
        case = (("--help",), 1, "h5py is not installed; install it, on Debian with apt-get install")
        for name in (*WRITERS, "watch"):
            check_refusals(self, name, [case], env=os.environ | {"PYTHONPATH": path})


class Inputs(unittest.TestCase):
    def setUp(self):
        small.folder()
        Path("folder").mkdir(exist_ok=True)
        Path("empty.h5").touch()
        Path("text.h5").write_text("no HDF5\n")
        Path("short.h5.part").write_text("rupture-record-part\nbytes 9000\n")
        if not Path("pipe").exists():
            os.mkfifo("pipe")

    def test_that_are_no_files_of_rupture(self):
        sentences = [
            ("", "an input has an empty name; give the path of a checkpoint or record"),
            ("folder", "folder is a folder; give the path of a checkpoint or record"),
            ("pipe", "pipe is not a regular file; give the path of a checkpoint or record"),
            ("small.h5/x", "small.h5/x does not exist; give the path of a checkpoint or record"),
            ("empty.h5", "empty.h5 is empty; expected a checkpoint or record"),
            ("text.h5", "text.h5 is not a rupture file: give one that rupture's programs wrote"),
            ("short.h5.part", "is truncated: it ends within its 512-byte header; copy it again"),
        ]
        for name, (_, ending) in WRITERS.items():
            output = ("-o", f"x{ending}")
            check_refusals(self, name, [((i, *output), 1, part) for i, part in sentences])
        check_refusals(self, "watch", [((i,), 1, part) for i, part in sentences[4:]])


class Outputs(unittest.TestCase):
    def setUp(self):
        small.folder()

    def test_that_cannot_be_written(self):
        for name, (given, ending) in WRITERS.items():
            folder = Path(f"folder{ending}")
            folder.mkdir(exist_ok=True)
            cases = [
                ("", 2, "an output has an empty name; give the path of a file"),
                ("-", 2, f"- has to end with {ending}"),
                (folder, 1, f"{folder} is a folder; give the path of a file to write"),
                (f"small.h5/x{ending}", 1, "small.h5 is no folder; give another path"),
                (f"/proc/x{ending}", 1, f"could not write /proc/x{ending}: "),
                (f"{'x' * 300}{ending}", 1, "File name too long"),
            ]
            check_refusals(self, name, [((given, "-f", "-o", o), c, part) for o, c, part in cases])

    def test_that_are_inputs(self):
        for name, (given, ending) in WRITERS.items():
            own = Path(f"own{ending}")
            own.write_bytes(Path(given).read_bytes())
            sentence = f"{own} is the input, which is never changed: give another output"
            check_refusals(self, name, [((own, "-o", own, "-f"), 2, sentence)])
            self.assertEqual(own.read_bytes(), Path(given).read_bytes())

    def test_for_which_the_disk_has_no_room(self):
        import_module("matplotlib.font_manager")  # writes its cache now, while there is room
        for name, (given, ending) in WRITERS.items():
            case = ((given, "-o", f"x{ending}"), 1, f"could not write x{ending}: File too large")
            if name == "xdmf":
                case = (*case[:2], "could not write x-derived.hdf5: File too large")
            check_refusals(self, name, [case], preexec_fn=no_room)

    def test_of_text(self):
        reasons = {"/dev/full": "No space left on device", "&-": "Bad file descriptor"}
        words = [
            f"{name} --{what}" for name in (*WRITERS, "watch") for what in ("help", "describe")
        ]
        for command in (*words, "watch --text small-record.h5"):
            for to, reason in reasons.items():
                shell = ["bash", "-c", f'"$RUPTURE_BIN"/{command} >{to}']
                done = subprocess.run(shell, stderr=subprocess.PIPE, text=True, check=False)
                sentence = f"rupture {command.split()[0]}: standard output: {reason}\n"
                self.assertEqual((done.returncode, done.stderr), (1, sentence))

    def test_with_all_streams_closed(self):
        for number, code in enumerate((0, 1)):
            command = '"$RUPTURE_BIN"/xdmf small.h5 -o closed.xdmf <&- >&- 2>&-'
            self.assertEqual(subprocess.run(["bash", "-c", command]).returncode, code)
        self.assertTrue(Path("closed.xdmf").read_text().startswith("<?xml"))


class Replacing(unittest.TestCase):
    def setUp(self):
        small.folder()
        Path("theirs").write_text("theirs")

    def left(self):
        return [path for path in Path().iterdir() if ".tmp." in path.name]

    def test_a_file_that_appears_meanwhile_is_kept(self):
        with self.assertRaises(FileExistsError), replacing("new", rename_to_new) as temporary:
            temporary.write_text("ours")
            os.link("theirs", "new")
        self.assertEqual((Path("new").read_text(), self.left()), ("theirs", []))

    def test_a_link_in_the_place_of_the_temporary_file_is_neither_followed_nor_deleted(self):
        with mock.patch("secrets.token_hex", return_value="0"):
            Path(".x.tmp.0").symlink_to("theirs")
            with self.assertRaises(FileExistsError), replacing("x"):
                pass
            Path(".x.tmp.0").unlink()
            with self.assertRaises(OSError), replacing("x") as temporary:
                temporary.rename("x")
                temporary.symlink_to("theirs")
        self.assertEqual([path.readlink() for path in self.left()], [Path("theirs")])
        self.assertEqual(Path("theirs").read_text(), "theirs")
        temporary.unlink()

    def test_file_and_folder_are_synced(self):
        synced = []

        def note(file):
            synced.append((os.readlink(f"/proc/self/fd/{file}"), Path("y").exists()))

        with mock.patch("os.fsync", note), replacing("y") as hidden:
            pass
        here = os.getcwd()
        self.assertEqual(synced, [(f"{here}/{hidden}", False), (here, True)])


if __name__ == "__main__":
    unittest.main()
