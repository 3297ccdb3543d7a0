"""`import rupture`: files, `.part` files, checksums and programs."""

import os
import shutil
import subprocess
import time
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
import rupture
import small

RECORDS = Path(__file__).resolve().parents[1] / "compatibility"


def killed(name, pieces):
    """The `.part` of a run of the small slider that was killed when its record had so many."""
    settings = [f"--set={key}={value}" for key, value in small.SMALL.items()]
    part = Path(f"{name}-record.h5.part")
    load = os.environ["RUPTURE_BIN"] + "/load"
    command = [load, "-o", f"{name}.h5", "--until", "0.2"]
    record = ["--record", f"{name}-record.h5", "--record-every", "2e-6"]
    run = subprocess.Popen([*command, *record, "--checkpoint-every", "1e-4", "-q", *settings])
    while not part.exists() or part.read_bytes().count(b"rupture-record-part\n") < pieces:
        time.sleep(0.01)
    run.kill()
    run.wait()
    return part


class Files(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()

    def fails(self, sentence, call, *arguments):
        with self.assertRaisesRegex(rupture.Failure, sentence):
            call(*arguments)

    def test_a_part_is_the_beginning_of_the_record(self):
        name = killed("part", 4)
        part, again, whole = rupture.open(name), rupture.open(name), self.result.record
        self.assertTrue(np.array_equal(part["tau"], again["tau"]))
        shared = min(len(part.time), len(whole.time))
        self.assertGreater(shared, 100)
        self.assertFalse(part.finished)
        self.assertTrue(whole.finished)
        for name in ("time", "tau", "pinned", "u_x"):
            self.assertTrue(np.array_equal(part[name][:shared], whole[name][:shared]), name)
        self.assertEqual(part.units("tau"), "N")
        self.assertEqual(part.parameters, whole.parameters)

    def test_a_part_ends_where_a_piece_is_not_whole(self):
        part = killed("torn", 4)
        data = part.read_bytes()
        start = data.rindex(b"rupture-record-part\n")
        cut, torn = Path("cut.h5.part"), Path("torn.h5.part")
        cut.write_bytes(data[:start])
        torn.write_bytes(data[:-1])
        self.assertTrue(np.array_equal(rupture.open(cut)["tau"], rupture.open(torn)["tau"]))
        torn.write_bytes(data[:600])
        self.fails("damaged", rupture.open, torn)

    def test_damage_and_other_files_are_refused(self):
        whole = Path("small.h5").read_bytes()
        bad = Path("bad.h5")
        for where in (3, 30, 60, 300, 511, 600, len(whole) - 1):
            bad.write_bytes(whole[:where] + bytes([whole[where] ^ 1]) + whole[where + 1 :])
            self.fails("is damaged|is not a rupture file", rupture.open, bad)
        bad.write_bytes(whole[:-1])
        self.fails("is damaged", rupture.open, bad)
        bad.write_bytes(b"")
        self.fails("is empty", rupture.open, bad)
        self.fails("does not exist", rupture.open, "none.h5")

    def test_contains_what_iteration_gives_and_nothing_else(self):
        record = self.result.record
        for file in (record, self.result.checkpoint, rupture.open(killed("in", 2))):
            listed = list(file)
            paths = [f"{file.home}/{name}" for name in listed]
            there = [path for path in paths if path in file.file]  # also with its group
            parameters = [f"parameters/{name.replace('.', '/')}" for name in file.parameters]
            odd = [
                "",
                ".",
                "junctions",
                "ruptures",
                "series",
                "state",
                "provenance/0/tool",
                3,
                None,
            ]
            odd += [f"/{name}" for name in listed] + [f"./{name}" for name in listed]
            odd += [f"{name}/" for name in listed] + [f"{name}/x" for name in listed]
            for name in [*listed, *paths, *parameters, *file.parameters, *odd]:
                self.assertEqual(name in file, name in {*listed, *there}, name)
        with mock.patch("rupture.files.datasets", side_effect=AssertionError("lists all")):
            self.assertIn("tau", record)
            self.assertNotIn("fields/u_x", record)
            self.assertIn("series/tau", record)
        self.assertEqual(record.get("nix", 5), 5)
        self.fails("has no ", record.dataset, "")

    def test_verifies_files_of_every_schema(self):
        for path in sorted(RECORDS.glob("schema-*/*.h5")):
            with rupture.open(path) as file:
                self.assertEqual(rupture.verify(path), file.checksum, path)

    def test_a_content_that_is_not_as_stated_is_damaged(self):
        def reseal(path):
            data = bytearray(path.read_bytes())
            data[:512] = rupture.envelope.sealed_header("rupture-checkpoint", memoryview(data))
            path.write_bytes(data)

        import h5py

        path = Path("changed.h5")
        shutil.copy("small.h5", path)
        with h5py.File(path, "r+") as file:
            file["state/u_x"][0, 0] += 1
        reseal(path)
        self.fails("its content has the checksum", rupture.verify, path)

    def test_names_that_a_file_lacks(self):
        checkpoint = rupture.open("small.h5")
        self.fails("has no u_y; did you mean u_[xz]?", checkpoint.units, "u_y")
        self.assertNotIn("u_y", checkpoint)
        self.assertIn("u_x", checkpoint)

    def test_xarray_and_pandas_hold_the_arrays(self):
        try:
            import pandas  # noqa: F401
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("pandas or xarray is not installed")
        record, checkpoint = self.result.record, self.result.checkpoint
        table, labelled = record.to_dataframe(), record.to_xarray()
        place = (record.time[5], record.x[3])
        self.assertEqual(table.loc[place, "tau"], record["tau"][5, 3])
        self.assertEqual(table.loc[place, "F_T"], record["F_T"][5])
        self.assertEqual(float(labelled["tau"].sel(time=place[0], x=place[1])), record["tau"][5, 3])
        self.assertEqual(labelled["tau"].attrs["units"], "N")
        state = checkpoint.to_xarray()
        self.assertEqual(state["u_x"].dims, ("z", "x"))
        self.assertEqual(state["junctions_attachment"].dims, ("x", "junction"))
        where = (checkpoint.z[2], checkpoint.x[4])
        self.assertEqual(checkpoint.to_dataframe().loc[where, "u_z"], checkpoint["u_z"][2, 4])


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()

    def test_that_draw_give_the_path_of_the_picture(self):
        path = rupture.run("map", "small-record.h5", output="map.png")
        self.assertEqual((path, path.read_bytes()[1:4]), (Path("map.png"), b"PNG"))

    def test_have_the_version_of_the_package(self):
        self.assertRegex(rupture.__version__, r"^\d+\.\d+\.\d+$")

    def test_a_result_has_the_files_of_its_run(self):
        names = [path.name for path in self.result.checkpoints]
        self.assertEqual(names[0], "small-t0.000500000.h5")
        self.assertEqual(len(names), 4)
        self.assertEqual(self.result.checksum, rupture.verify("small.h5"))

    def test_a_refusal_is_its_sentence(self):
        with self.assertRaisesRegex(rupture.Failure, "^load: small.h5 exists"):
            rupture.run("load", output="small.h5", until=0.001)
        os.environ["RUPTURE_BIN"], kept = "/nowhere", os.environ["RUPTURE_BIN"]
        with self.assertRaisesRegex(rupture.Failure, "RUPTURE_BIN=/nowhere"):
            rupture.run("load", output="other.h5")
        os.environ["RUPTURE_BIN"] = kept

    def test_files_that_are_open_are_inputs(self):
        made = rupture.run("modify-phi", self.result.checkpoint, output="phi.h5", shape="uniform")
        self.assertEqual(made.checkpoint.provenance[-1]["tool"], "modify-phi")
        self.assertEqual(made.checkpoints, [])


if __name__ == "__main__":
    unittest.main()
