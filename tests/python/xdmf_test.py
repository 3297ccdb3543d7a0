"""xdmf: both readers of VTK, as they are in ParaView, find the values of the checkpoints."""

import os
import unittest
from pathlib import Path

import numpy as np
import rupture
import small
from conftest import skip
from program import check_description, check_refusals, ran

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader
except ImportError:
    skip("python3-paraview, which has VTK's readers, is not installed.")


class Xdmf(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()
        (self.folder / "sub").mkdir(exist_ok=True)
        self.output = self.folder / "sub/run.xdmf"
        paths = reversed(self.result.checkpoints)
        self.assertEqual(ran("xdmf", *paths, "-o", self.output, "-f"), (0, "", ""))

    def grids(self, reader, checkpoint):
        """Bulk and interface at its time, as VTK gives them."""
        reader.SetFileName(str(self.output))
        reader.UpdateInformation()
        key, about = vtkStreamingDemandDrivenPipeline.TIME_STEPS(), reader.GetOutputInformation(0)
        times = [about.Get(key, n) for n in range(about.Length(key))]
        self.assertEqual(times, [rupture.open(p).time for p in self.result.checkpoints])
        reader.UpdateTimeStep(checkpoint.time)
        block = reader.GetOutputDataObject(0)
        while block.GetNumberOfBlocks() == 1:
            block = block.GetBlock(0)
        return block.GetBlock(0), block.GetBlock(1)

    def array(self, grid, name):
        return vtk_to_numpy(grid.GetPointData().GetArray(name))

    def test_values_are_those_of_the_checkpoints(self):
        for kind in (vtkXdmfReader, vtkXdmf3Reader):
            for path in self.result.checkpoints[1:3]:
                checkpoint = rupture.open(path)
                reader = kind()  # Xdmf3's arrays live as long as it does
                bulk, interface = self.grids(reader, checkpoint)
                for name in ("u_x", "u_z", "v_x", "v_z"):
                    expected = checkpoint[name].ravel()
                    self.assertTrue(np.array_equal(self.array(bulk, name), expected), name)
                point = bulk.GetPoint(17 * 2 + 3)  # row 2, block 3
                self.assertTrue(np.allclose(point, (checkpoint.x[3], checkpoint.z[2], 0)))
                stress = rupture.analyze("stress", checkpoint)
                for name in ("tau", "p"):
                    self.assertTrue(np.array_equal(self.array(interface, name), stress[name]))
                pinned = self.array(interface, "pinned_fraction")
                self.assertTrue(np.array_equal(pinned, checkpoint.pinned_fraction))

    def test_the_stress_bears_the_normal_load(self):
        still = rupture.run("load", output="equilibrium.h5", set=small.SMALL).checkpoint
        command = ("xdmf", still.path, "-o", "still.xdmf", "-f")
        self.assertEqual(ran(*command), (0, "", ""))
        import h5py

        p = still.parameters
        with h5py.File("still-derived.hdf5") as file:
            middle = file["0000/sigma_zz"][4].mean()
        load = p["slider.F_N"] / (p["slider.L"] * p["slider.B"])
        self.assertAlmostEqual(middle / -load, 1, delta=0.1)

    def test_does_not_copy_the_checkpoints(self):
        derived = self.output.with_name("run-derived.hdf5")
        import h5py

        with h5py.File(derived) as file:
            self.assertFalse({"u_x", "v_x", "attachment"} & set(file["0000"]))

    def test_leaves_a_folder_that_can_be_verified(self):
        code, found, _ = ran("analyze", "verify", self.folder)
        self.assertEqual((code, found.count("intact  ")), (0, len(list(Path().glob("*.h5")))))

    def test_equal_checkpoints_count_once(self):
        paths = self.result.checkpoints
        Path("copy.h5").write_bytes(Path(paths[1]).read_bytes())
        self.assertEqual(ran("xdmf", *paths, "copy.h5", "-o", "once.xdmf"), (0, "", ""))
        self.assertEqual(Path("once.xdmf").read_text().count("<Time "), len(paths))

    def test_refuses(self):
        rupture.run("modify-phi", "small.h5", output="wider.h5", shape="bell")
        Path("a:b.h5").write_bytes(Path("small.h5").read_bytes())
        odd = os.fsdecode(b"\xff.h5")
        Path(odd).write_bytes(Path("small.h5").read_bytes())
        to = ("-o", "x.xdmf")
        cases = [
            (to, 2, "are required: CHECKPOINT"),
            (("none.h5", *to), 1, "none.h5 does not exist"),
            (("small.h5", "small-record.h5", *to), 1, "small-record.h5 is a record"),
            (
                ("small.h5", "wider.h5", *to),
                1,
                "small.h5 and wider.h5 are different states of t = 0.002 s; a series has one state"
                " of a time: leave one out",
            ),
            (("small.h5", "-o", "x.vtk"), 2, "has to end with .xdmf"),
            (("small.h5", "-o", self.output), 1, "exists"),
            (("a:b.h5", *to), 1, "colon"),
            ((odd, *to), 1, "has an unusual character in its name, which XDMF cannot refer to"),
            (("small.h5", "-o", ""), 2, "an output has an empty name"),
        ]
        check_refusals(self, "xdmf", cases)

    def test_refuses_to_replace_its_input(self):
        checkpoint = Path("own-derived.hdf5")
        checkpoint.write_bytes(Path("small.h5").read_bytes())
        case = ((checkpoint, "-o", "own.xdmf", "-f"), 2, "is the input, which is never changed")
        check_refusals(self, "xdmf", [case])
        self.assertEqual(checkpoint.read_bytes(), Path("small.h5").read_bytes())

    def test_describes_itself(self):
        check_description(self, "xdmf")


if __name__ == "__main__":
    unittest.main()
