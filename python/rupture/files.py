"""Checkpoints and records as numpy arrays.

The examples use a checkpoint and a record of a small slider:

>>> checkpoint, record = rupture.open("small.h5"), rupture.open("small-record.h5")
"""

import difflib
import io
import os
from collections import namedtuple
from collections.abc import Mapping
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory

import h5py
import numpy as np

from rupture import tables
from rupture.elasticity import POISSON
from rupture.envelope import CHECKPOINT, PART, check_seal, kind_of, mapped
from rupture.errors import Failure, NoSuchName
from rupture.layout import WORDS, Content
from rupture.programs import output_of
from rupture.tables import text

Ruptures = namedtuple("Ruptures", "time step block x")


def plain(value):
    """A number or a text as a Python object; a list of an array."""
    return text(value) if isinstance(value, bytes) else value.tolist()


def no_such_name(where, name, known, listed):
    """NoSuchName, with the most similar of the known names, or those that are listed."""
    near = difflib.get_close_matches(f"{name}", known, 1)
    hint = f"; did you mean {near[0]}?" if near else f"; it has {', '.join(listed)}"
    return NoSuchName(f"{where} has no {name}{hint}")


class Parameters(dict):
    """Parameters by name. Its KeyErrors are Failures, too."""

    def __missing__(self, name):
        raise no_such_name("the file", name, self, self)


@contextmanager
def reading(path):
    """What HDF5 and h5py raise is one sentence."""
    try:
        yield
    except (OSError, RuntimeError, KeyError, TypeError, ValueError) as error:
        hint = "copy it again or recreate it"
        raise Failure(f"{path}: HDF5 cannot read it: {error}; {hint}") from None


class File(Mapping):
    """What checkpoints and records have in common. A mapping from names to arrays, which are read
    from the file when they are used. Works in `with`.

    >>> sorted(checkpoint)[:3]
    ['drive/origin_position', 'drive/origin_step', 'f_x']
    """

    home: str  # the group whose datasets need no group in their name
    axes: tuple  # the dimensions of most arrays of this group

    def __init__(self, path, file, content):
        self.path = Path(os.fsdecode(path))
        self.opened = file
        self.content = content  # the datasets
        content.check(self)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.opened.close()

    @property
    def file(self):
        """The h5py.File."""
        if not self.opened:
            raise Failure(f"{self.path} was closed: open it again")
        return self.opened

    def __repr__(self):
        name = f"<rupture.{type(self).__name__} {str(self.path)!r}:"
        if not self.opened:
            return f"{name} closed>"
        shapes = {one: " x ".join(map(str, self.dataset(one).shape)) or "-" for one in self}
        rows = [f"{one:23} {shape:12} {self.units(one)}" for one, shape in shapes.items()]
        return "\n  ".join([name, *rows]) + ">"

    def dataset(self, name):
        """The h5py.Dataset of a name, a path or, if there is a dot in it, a parameter."""
        name = f"{name}".lstrip("/")
        for path in (f"/{self.home}/{name}", f"/{name}", f"/parameters/{name.replace('.', '/')}"):
            if path in self.content:
                return self.file[path]
        raise no_such_name(self.path, name, [*self, *self.parameters], self)

    def __getitem__(self, name):
        """The array of this name in SI units, such as "u_x"; a number where it is one.

        >>> checkpoint["u_x"].shape
        (9, 17)
        """
        value = self.value_of(self.dataset(name))
        if not isinstance(value, np.ndarray):
            return plain(value)
        return value.astype(int) if value.dtype.kind == "u" else value  # counts may be subtracted

    def value_of(self, dataset):
        with reading(self.path):
            self.content.check_values(dataset.name, value := dataset[()], self)
        return value

    def __contains__(self, name):
        """Whether iteration yields this name, which may include its group."""
        return name in self.paths or f"{self.home}/{name}" in self.paths

    def __iter__(self):
        return (path.removeprefix(f"{self.home}/") for path in self.paths)

    def __len__(self):
        return sum(1 for _ in self)

    @property
    def paths(self):
        others = ("/parameters/", "/provenance/", "/run/", "/alarm/")
        return [path[1:] for path in self.content if not path.startswith(others)]

    def units(self, name):
        """The unit of an array or of a parameter; "1" where it has none.

        >>> record.units("tau"), record.units("slider.L")
        ('N', 'm')
        """
        return text(self.dataset(name).attrs["unit"])

    @cached_property
    def parameters(self):
        """All parameters by name, in SI units; a list with the value of each block where one varies
        along x. `rupture.run(set=...)` takes them.

        >>> record.parameters["slider.L"], record.parameters["junctions.law"]
        (0.14, 'reference')
        """
        paths = [path for path in self.content if path.startswith("/parameters/")]
        values = {
            path[12:].replace("/", "."): plain(self.value_of(self.file[path])) for path in paths
        }
        for name in WORDS.keys() & values:
            if isinstance(values[name], list):
                values[name] = [WORDS[name][number] for number in values[name]]
        return Parameters(values)

    @cached_property
    def sizes(self):
        """Lengths in the table of layout.py, and the last block."""
        Nx, Nz = self.parameters["slider.Nx"], self.parameters["slider.Nz"]
        return {"Nx": Nx, "Nz": Nz, "S": self.springs_per_block, "last": Nx - 1}

    @property
    def provenance(self):
        """The steps that led to this file, oldest first.

        >>> [step["tool"] for step in checkpoint.provenance]
        ['load']
        """
        steps = self.file.get("provenance", {})
        read = self.value_of
        return [{name: plain(read(steps[n][name])) for name in steps[n]} for n in sorted(steps)]

    @property
    def checksum(self):
        """The content checksum that the file states; `rupture.verify()` recomputes it. That of an
        unfinished record is of what has been written so far."""
        return text(self.file.attrs.get("content_checksum", ""))

    @property
    def x(self):
        """Positions of the blocks along the interface, from the driven side [m].

        >>> record.x[:3]
        array([0.     , 0.00875, 0.0175 ])
        """
        return np.linspace(0, self.parameters["slider.L"], self.parameters["slider.Nx"])

    @property
    def z(self):
        """Heights of the rows of blocks above the interface [m]."""
        return np.linspace(0, self.parameters["slider.H"], self.parameters["slider.Nz"])

    @property
    def c_s(self):
        """Shear wave speed sqrt(G / rho), Poisson ratio 1/3 [m/s].

        >>> round(record.c_s)
        935
        """
        p = {name: self.parameters[f"slider.{name}"] for name in "LHBME"}
        density = p["M"] / (p["L"] * p["H"] * p["B"])
        return np.sqrt(p["E"] / (2 * (1 + POISSON)) / density)

    @property
    def springs_per_block(self):
        simplified = self.parameters["junctions.law"] == "simplified"
        return 1 if simplified else self.parameters["junctions.N_s"]

    def to_dataframe(self):
        """A pandas.DataFrame: a row for each sample and block of a record, or for each block of a
        checkpoint. Arrays of other dimensions are left out.

        >>> record.to_dataframe().index.names
        FrozenList(['time', 'x'])
        """
        return tables.to_dataframe(self)


class Checkpoint(File):
    """The whole state of a slider. Blocks are [Nz][Nx], row 0 being the interface; junctions are
    [Nx][S].

    >>> checkpoint
    <rupture.Checkpoint 'small.h5':
      drive/origin_position   -            m
      ...
      u_x                     9 x 17       m
      ...
    """

    home = "state"
    axes = ("z", "x")

    @property
    def time(self):
        """[s]

        >>> checkpoint.time
        0.002
        """
        step = self["step"] - self.get("clock/origin_step", 0)
        return self.get("clock/origin_time", 0.0) + step * self.parameters["numerics.dt"]

    @property
    def pinned_fraction(self):
        """Fraction of each interface block's junctions that are pinned, [Nx]."""
        return 1 - self["junctions/slipping"].mean(axis=1)


class Record(File):
    """Time series of the interface of one run: [n] or [n][Nx].

    >>> record["tau"].shape == (len(record.time), len(record.x))
    True
    """

    home = "series"
    finished = True  # False for a `.part`, of a run that is in progress or was interrupted
    axes = ("time", "x")

    @property
    def time(self):
        """Times of the samples [s]."""
        return self["time"]

    @property
    def ruptures(self):
        """When each block ruptured: time [s], step, block and x [m], an array each.

        >>> record.ruptures.time[:2], record.ruptures.block[:2]
        (array([0.000117 , 0.0001278]), array([1, 2]))
        """
        columns = {name: self[f"ruptures/{name}"] for name in ("time", "step", "block")}
        return Ruptures(**columns, x=self.x[columns["block"]])

    @property
    def pinned_fraction(self):
        """Fraction of each block's junctions that are pinned, [n][Nx].

        >>> float(record.pinned_fraction[0].min())
        1.0
        """
        return self["pinned"] / self.springs_per_block


class Unlocked(io.BufferedReader):
    """A file that HDF5 need not open itself: it would lock it, which fails on some file systems and
    while another program does. Nobody closes it but HDF5, by no longer using it."""

    __del__ = io.BufferedReader.close


def open_file(path):
    """A `Checkpoint` or a `Record`, after a check of the SHA-256 over its bytes. A `.part` is read
    as far as it has been written; to see later samples, open it again.

    >>> rupture.open("small.h5").time
    0.002
    """
    data = mapped(path)
    if (kind := kind_of(data, path)) == PART:
        return open_part(path)
    check_seal(data, path)
    with reading(path):
        file = h5py.File(Unlocked(io.FileIO(path)), "r")
        content = Content(file, path, kind, len(data))
        return (Checkpoint if kind == CHECKPOINT else Record)(path, file, content)


def open_part(path):
    """The record that `rupture finish` makes of it, which nobody else sees."""
    with TemporaryDirectory() as folder:
        output_of("finish", "--quiet", "-o", f"{folder}/record.h5", "--", path)
        record = open_file(f"{folder}/record.h5")
    record.path, record.finished = Path(path), False
    return record
