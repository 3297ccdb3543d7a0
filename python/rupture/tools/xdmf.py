"""xdmf: checkpoints for ParaView and VTK."""

import io
import os
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import h5py
import numpy as np

from rupture.elasticity import STRESSES, stress_of
from rupture.errors import Failure
from rupture.files import Checkpoint, open_file
from rupture.programs import analyze
from rupture.tools.command_line import Parser
from rupture.tools.output import check_output, complete, progress, say_written

STATE = ("u_x", "u_z", "v_x", "v_z")
INTERFACE = ("tau", "p", "pinned_fraction")


def parse_options():
    made = Parser(
        "xdmf CHECKPOINT... -o FILE.xdmf [options]",
        "Writes a file with which ParaView and VTK open checkpoints as one series in time:"
        " displacement, velocity and stress of the blocks; tau, p and the pinned fraction along the"
        " interface. It refers to the checkpoints, which must stay where they are. Stresses and"
        " interface, which must be computed, are written to FILE-derived.hdf5.",
        "checkpoint",
    )
    made.add_argument("checkpoints", metavar="CHECKPOINT", nargs="+")
    made.add_output("file to write: .xdmf")
    return made.parse_args()


def open_checkpoint(path):
    checkpoint = open_file(path)
    if isinstance(checkpoint, Checkpoint):
        return checkpoint
    raise Failure(f"{path} is a record; give checkpoints")


def in_time(checkpoints):
    """One checkpoint per time, in order: the last one of a run is often also its end."""
    series: dict = {}
    for checkpoint in checkpoints:
        other = series.setdefault(checkpoint.time, checkpoint)
        if other.checksum != checkpoint.checksum:
            raise Failure(
                f"{other.path} and {checkpoint.path} are different states of t ="
                f" {checkpoint.time:g} s; a series has one state per time: leave one out"
            )
    return [series[time] for time in sorted(series)]


def refuse_odd_names(names):
    """Refuses names that XDMF cannot refer to: it is XML, and a colon ends a file's name."""
    for name in names:
        if ":" in name or not name.isprintable():
            what = "a colon" if ":" in name else "an unusual character"
            raise Failure(f"{name} has {what} in its name, which XDMF cannot refer to; rename it")


def write_derived(group, checkpoint):
    """Writes the quantities that are computed from a checkpoint."""
    bulk = stress_of(checkpoint["u_x"], checkpoint["u_z"], checkpoint.parameters)
    places = np.stack(np.broadcast_arrays(checkpoint.x, checkpoint.z[:, None], 0.0), axis=-1)
    group.create_dataset("slider", data=places)
    group.create_dataset("interface", data=places[:1])
    report = analyze("stress", checkpoint)
    along = ([report["tau"]], [report["p"]], [checkpoint.pinned_fraction])  # one row
    for names, arrays, units in ((STRESSES, bulk, ["Pa"] * 3), (INTERFACE, along, ["N", "N", "1"])):
        for name, array, unit in zip(names, arrays, units):
            group.create_dataset(name, data=array).attrs["unit"] = unit


def item(place, shape):
    """Numbers in an HDF5 file; `place` is FILE:/PATH."""
    size = " ".join(map(str, shape))
    kind = 'Format="HDF" NumberType="Float" Precision="8"'
    return f'<DataItem {kind} Dimensions="{size}">{escape(place)}</DataItem>'


def scalar(name, place, shape):
    return f'<Attribute Name="{name}" Center="Node">{item(place, shape)}</Attribute>'


def grid(name, shape, points, attributes):
    """Blocks are points, rows first. (VTK's readers disagree about
    their plane; so the positions stand in the file.)"""
    size = " ".join(map(str, shape))
    return (
        f'<Grid Name="{name}"><Topology TopologyType="2DSMesh" Dimensions="{size}"/>'
        f'<Geometry GeometryType="XYZ">{item(points, (*shape, 3))}</Geometry>'
        f"{''.join(attributes)}</Grid>"
    )


def step_of(checkpoint, state, derived):
    """The grids of one time. `state` and `derived` are the places of the groups."""
    shape = checkpoint["u_x"].shape
    bulk = [scalar(name, f"{state}/{name}", shape) for name in STATE]
    bulk += [scalar(name, f"{derived}/{name}", shape) for name in STRESSES]
    along = [scalar(name, f"{derived}/{name}", (1, shape[1])) for name in INTERFACE]
    grids = grid("slider", shape, f"{derived}/slider", bulk)
    grids += grid("interface", (1, shape[1]), f"{derived}/interface", along)
    time = f'<Time Value="{checkpoint.time!r}"/>'
    return f'<Grid Name="t" GridType="Collection" CollectionType="Spatial">{time}{grids}</Grid>\n'


def text_of(name, steps):
    series = f'<Grid Name={quoteattr(name)} GridType="Collection" CollectionType="Temporal">'
    text = f'<Xdmf Version="3.0"><Domain>{series}\n{"".join(steps)}</Grid></Domain></Xdmf>\n'
    return f'<?xml version="1.0"?>\n{text}'


def write_numbers(path, checkpoints):
    """Writes the file in memory first, because libhdf5 does not survive a full disk."""
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        for number, checkpoint in enumerate(progress(checkpoints, len(checkpoints), "state")):
            write_derived(file.create_group(f"{number:04}"), checkpoint)
    path.write_bytes(image.getvalue())


def write_all(checkpoints, output, derived, force):
    """Renames neither file before both are written, and last the one that refers to the other."""
    beside = [os.path.relpath(one.path, output.parent) for one in checkpoints]
    refuse_odd_names([*beside, derived.name])
    steps = [
        step_of(checkpoint, f"{path}:/state", f"{derived.name}:/{number:04}")
        for number, (checkpoint, path) in enumerate(zip(checkpoints, beside))
    ]
    with complete(output, force) as text, complete(derived, force) as numbers:
        write_numbers(numbers, checkpoints)
        text.write_text(text_of(output.stem, steps), encoding="utf-8")


def run():
    options = parse_options()
    check_output(options.output, options.force, (".xdmf", ".xmf"), options.checkpoints)
    output = Path(options.output)
    derived = output.with_name(f"{output.stem}-derived.hdf5")
    check_output(derived, options.force, inputs=options.checkpoints)
    checkpoints = [open_checkpoint(path) for path in options.checkpoints]
    write_all(in_time(checkpoints), output, derived, options.force)
    say_written(derived, output)
