"""xdmf: checkpoints, or the fields of a record, for ParaView and VTK."""

import io
import math
import os
from collections import namedtuple
from functools import partial
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import h5py
import numpy as np

from rupture.elasticity import STRESSES, stress_of
from rupture.errors import Failure, UsageError
from rupture.files import Record, open_file
from rupture.programs import analyze, verify
from rupture.tools.command_line import Parser
from rupture.tools.output import check_output, complete, progress, say_written

DISPLACEMENT, VELOCITY = ("u_x", "u_z"), ("v_x", "v_z")
FORCES = ("tau", "p")
INTERFACE = (*FORCES, "pinned_fraction")
GRIDS = ("slider", "interface")

# One time of the series: which of how many fields of a record it is, None of a checkpoint; and
# what returns DISPLACEMENT and INTERFACE.
Step = namedtuple("Step", "time file field arrays")


def parse_options():
    made = Parser(
        "xdmf FILE... -o FILE.xdmf [options]",
        "Writes a file with which ParaView and VTK open checkpoints, or a record with --fields,"
        " as one series in time: displacement, velocity (of checkpoints) and stress of blocks;"
        " tau, p and the pinned fraction along the interface. It refers to the files, which must"
        " stay where they are. Stresses and interface, which must be computed, are written to"
        " FILE-derived.hdf5.",
        "file",
    )
    made.add_argument("files", metavar="FILE", nargs="+", help="checkpoints, or one record")
    made.add_output("file to write: .xdmf")
    return made.parse_args()


def short(time):
    """The short decimal that a time is but for the rounding of steps times dt: 0.8, not
    0.7999999999999999. Other times stay as they are."""
    rounded = float(f"{time:.12g}")
    return rounded if math.isclose(rounded, time, rel_tol=1e-15) else float(time)


def arrays_of(checkpoint):
    found = {name: checkpoint[name] for name in DISPLACEMENT}
    report = analyze("stress", checkpoint)
    found |= {name: np.array(report[name], dtype=float) for name in FORCES}  # None is NaN
    return found | {"pinned_fraction": checkpoint.pinned_fraction}


def fields_of(record):
    """The steps of the fields. A run also samples the interface when it stores a field."""
    if not record.finished:
        raise Failure(f"{record.path} is unfinished: complete it with rupture finish")
    if "fields/time" not in record:
        raise Failure(f"{record.path} has no fields: run it again with --fields")
    verify(record.path)
    times = record["fields/time"]
    rows = np.searchsorted(record.time, times)
    arrays = {name: record[f"fields/{name}"] for name in DISPLACEMENT}
    arrays |= {name: record[name][rows] for name in FORCES}
    arrays["pinned_fraction"] = record.pinned_fraction[rows]

    def at(number):
        return {name: array[number].astype(float) for name, array in arrays.items()}

    return [
        Step(short(time), record, (n, len(times)), partial(at, n)) for n, time in enumerate(times)
    ]


def steps_of(files):
    """The steps in order of time. There is one checkpoint per time: the last of a run is often also
    its end."""
    if len(files) == 1 and isinstance(files[0], Record):
        return fields_of(files[0])
    series: dict = {}
    for file in files:
        if isinstance(file, Record):
            raise UsageError(f"{file.path} is a record: give checkpoints, or one record alone")
        other = series.setdefault(short(file.time), file)
        if other.checksum != file.checksum:
            raise Failure(
                f"{other.path} and {file.path} are different states of t ="
                f" {file.time:g} s; a series has one state per time: leave one out"
            )
    return [
        Step(time, series[time], None, partial(arrays_of, series[time])) for time in sorted(series)
    ]


def write_derived(group, step):
    """Writes the quantities that are computed."""
    arrays = step.arrays()
    bulk = stress_of(arrays["u_x"], arrays["u_z"], step.file.parameters)
    places = np.stack(np.broadcast_arrays(step.file.x, step.file.z[:, None], 0.0), axis=-1)
    group.create_dataset("slider", data=places)
    group.create_dataset("interface", data=places[:1])
    along = [[arrays[name]] for name in INTERFACE]  # one row
    for names, arrays, units in ((STRESSES, bulk, ["Pa"] * 3), (INTERFACE, along, ["N", "N", "1"])):
        for name, array, unit in zip(names, arrays, units):
            group.create_dataset(name, data=array).attrs["unit"] = unit


def size_of(shape):
    return " ".join(map(str, shape))


def item(place, shape, bytes_each=8):
    """Numbers in an HDF5 file; `place` is FILE:/PATH."""
    kind = f'Format="HDF" NumberType="Float" Precision="{bytes_each}"'
    return f'<DataItem {kind} Dimensions="{size_of(shape)}">{escape(place)}</DataItem>'


def field_item(place, number, count, shape):
    """One field of a record, which has `count`."""
    numbers = size_of((number, 0, 0, 1, 1, 1, 1, *shape))  # start, stride, count
    return (
        f'<DataItem ItemType="HyperSlab" Dimensions="{size_of(shape)}">'
        f'<DataItem Format="XML" Dimensions="3 3">{numbers}</DataItem>'
        f"{item(place, (count, *shape), 4)}</DataItem>"
    )


def scalar(name, data):
    return f'<Attribute Name="{name}" Center="Node">{data}</Attribute>'


def grid(name, time, shape, points, attributes):
    """Blocks are points, rows first. (VTK's readers disagree about
    their plane; so the positions stand in the file.)"""
    return (
        f'<Grid Name="{name}"><Time Value="{time!r}"/>'
        f'<Topology TopologyType="2DSMesh" Dimensions="{size_of(shape)}"/>'
        f'<Geometry GeometryType="XYZ">{item(points, (*shape, 3))}</Geometry>'
        f"{''.join(attributes)}</Grid>\n"
    )


def grids_of(step, file, derived):
    """Slider and interface at one time. `file` and `derived` are the places of file and group."""
    shape = len(step.file.z), len(step.file.x)
    along = [scalar(name, item(f"{derived}/{name}", (1, shape[1]))) for name in INTERFACE]
    if step.field is None:
        bulk = [
            scalar(name, item(f"{file}:/state/{name}", shape)) for name in DISPLACEMENT + VELOCITY
        ]
    else:
        places = {name: f"{file}:/fields/{name}" for name in DISPLACEMENT}
        number, count = step.field
        bulk = [scalar(n, field_item(place, number, count, shape)) for n, place in places.items()]
    bulk += [scalar(name, item(f"{derived}/{name}", shape)) for name in STRESSES]
    return (
        grid("slider", step.time, shape, f"{derived}/slider", bulk),
        grid("interface", step.time, (1, shape[1]), f"{derived}/interface", along),
    )


def text_of(grids):
    """A series of each grid. (In one series of both, ParaView would number the names of the
    blocks.)"""
    kind = 'GridType="Collection" CollectionType="Temporal"'
    series = [
        f"<Grid Name={quoteattr(name)} {kind}>\n{''.join(steps)}</Grid>\n"
        for name, steps in zip(GRIDS, zip(*grids))
    ]
    text = f'<Xdmf Version="3.0"><Domain>\n{"".join(series)}</Domain></Xdmf>\n'
    return f'<?xml version="1.0"?>\n{text}'


def write_numbers(path, steps):
    """Writes the file in memory first, because libhdf5 does not survive a full disk."""
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        for number, step in enumerate(progress(steps, len(steps), "state")):
            write_derived(file.create_group(f"{number:04}"), step)
    path.write_bytes(image.getvalue())


def write_all(steps, output, derived, force):
    """Renames neither file before both are written, and last the one that refers to the other."""
    beside = [os.path.relpath(step.file.path, output.parent) for step in steps]
    for name in (*beside, derived.name):  # XDMF is XML, in which a colon ends a file's name
        if ":" in name or not name.isprintable():
            what = "a colon" if ":" in name else "an unusual character"
            raise Failure(f"{name} has {what} in its name, which XDMF cannot refer to; rename it")
    grids = [
        grids_of(step, path, f"{derived.name}:/{number:04}")
        for number, (step, path) in enumerate(zip(steps, beside))
    ]
    with complete(output, force) as text, complete(derived, force) as numbers:
        write_numbers(numbers, steps)
        text.write_text(text_of(grids), encoding="utf-8")


def run():
    options = parse_options()
    check_output(options.output, options.force, (".xdmf", ".xmf"), options.files)
    output = Path(options.output)
    derived = output.with_name(f"{output.stem}-derived.hdf5")
    check_output(derived, options.force, inputs=options.files)
    steps = steps_of([open_file(path) for path in options.files])
    write_all(steps, output, derived, options.force)
    say_written(derived, output)
