"""xdmf: both readers of VTK, as they are in ParaView, find the values of the checkpoints."""

from pathlib import Path

import h5py
import numpy as np
import pytest

import rupture
from conftest import SMALL, draws, run, skip
from rupture.tools.xdmf import short

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkFiltersExtraction import vtkExtractBlockUsingDataAssembly
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader
except ImportError:
    skip("python3-paraview, which has VTK's readers, is not installed.")


OUTPUT = Path("sub/run.xdmf")


@pytest.fixture
def series(small):
    """The paths of checkpoints, of which OUTPUT was written."""
    OUTPUT.parent.mkdir(exist_ok=True)
    draws("xdmf", *reversed(small.checkpoints), "-o", OUTPUT, "-f")
    return small.checkpoints


def grids(reader, checkpoint, series):
    """Bulk and interface at its time, as VTK gives them."""
    reader.SetFileName(str(OUTPUT))
    reader.UpdateInformation()
    key, about = vtkStreamingDemandDrivenPipeline.TIME_STEPS(), reader.GetOutputInformation(0)
    times = [about.Get(key, n) for n in range(about.Length(key))]
    assert times == [rupture.open(path).time for path in series]
    reader.UpdateTimeStep(checkpoint.time)
    block = reader.GetOutputDataObject(0)
    while block.GetNumberOfBlocks() == 1:
        block = block.GetBlock(0)
    return block.GetBlock(0), block.GetBlock(1)


def holds(grid, name, expected):
    return np.array_equal(vtk_to_numpy(grid.GetPointData().GetArray(name)), np.ravel(expected))


@pytest.mark.parametrize("kind", [vtkXdmfReader, vtkXdmf3Reader])
@pytest.mark.parametrize("number", [2])
def test_values_are_those_of_the_checkpoints(series, kind, number):
    checkpoint = rupture.open(series[number])
    reader = kind()  # Xdmf3's arrays live as long as it does
    bulk, interface = grids(reader, checkpoint, series)
    assert all(holds(bulk, name, checkpoint[name]) for name in ("u_x", "u_z", "v_x", "v_z"))
    point = bulk.GetPoint(17 * 2 + 3)  # row 2, block 3
    assert np.allclose(point, (checkpoint.x[3], checkpoint.z[2], 0))
    stress = rupture.analyze("stress", checkpoint)
    assert all(holds(interface, name, stress[name]) for name in ("tau", "p"))
    assert holds(interface, "pinned_fraction", checkpoint.pinned_fraction)


def block_named(block, time):
    """The arrays of the block that ParaView's filter extracts by this name."""
    reader, extract = vtkXdmfReader(), vtkExtractBlockUsingDataAssembly()
    reader.SetFileName(str(OUTPUT))
    extract.SetInputConnection(reader.GetOutputPort())
    extract.AddSelector(f"//{block}")
    extract.UpdateTimeStep(time)
    found = extract.GetOutputDataObject(0)
    while found.GetClassName() == "vtkMultiBlockDataSet":
        found = next(b for n in range(found.GetNumberOfBlocks()) if (b := found.GetBlock(n)))
    arrays = found.GetPointData()
    names = [arrays.GetArrayName(n) for n in range(arrays.GetNumberOfArrays())]
    return {name: vtk_to_numpy(arrays.GetArray(name)) for name in names}


def test_fields_of_a_record_are_a_series(folder):
    OUTPUT.parent.mkdir()
    options = {"until": 1e-3, "record_every": 1e-4, "fields": 2e-4, "config": SMALL}
    record = rupture.run("load", output="f.h5", record="f-record.h5", **options).record
    draws("xdmf", "f-record.h5", "-o", OUTPUT)
    times = [short(time) for time in record["fields/time"]]
    assert times[:3] == [0.0, 0.0002, 0.0004] != [*record["fields/time"][:3]]
    for number, time in enumerate(times):
        slider, interface = block_named("slider", time), block_named("interface", time)
        assert {*slider} == {"u_x", "u_z", "sigma_xx", "sigma_zz", "sigma_xz"}
        for name in ("u_x", "u_z"):
            assert np.array_equal(slider[name], record[f"fields/{name}"][number].ravel())
        for name in ("tau", "p"):
            assert np.array_equal(interface[name], record[name][2 * number])
        assert np.array_equal(interface["pinned_fraction"], record.pinned_fraction[2 * number])


def test_times_are_short_where_only_rounding_makes_them_long():
    others = [1 / 3, 0.8 + 1e-12]
    assert [short(time) for time in (4000000 * 2e-7, *others)] == [0.8, *others]


def test_the_stress_bears_the_normal_load(folder):
    still = rupture.run("load", output="equilibrium.h5", config=SMALL).checkpoint
    draws("xdmf", still.path, "-o", "still.xdmf")
    p = still.parameters
    with h5py.File("still-derived.hdf5") as file:
        middle = file["0000/sigma_zz"][4].mean()
    load = p["slider.F_N"] / (p["slider.L"] * p["slider.B"])
    assert middle / -load == pytest.approx(1, abs=0.1)


def test_does_not_copy_the_checkpoints(series):
    with h5py.File(OUTPUT.with_name("run-derived.hdf5")) as file:
        assert not {"u_x", "v_x", "attachment"} & set(file["0000"])


def test_leaves_a_folder_that_can_be_verified(series):
    done = run("analyze", "verify", ".")
    assert (done.returncode, done.stdout.count("intact  ")) == (0, len(list(Path().glob("*.h5"))))


def test_equal_checkpoints_count_once(series):
    Path("copy.h5").write_bytes(series[1].read_bytes())
    draws("xdmf", *series, "copy.h5", "-o", "once.xdmf")
    assert Path("once.xdmf").read_text().count("<Time ") == 2 * len(series)
