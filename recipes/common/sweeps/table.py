"""The table of a user's sweep as CSV and as HDF5: the same columns and units. Numbers are
written with all their digits; equal tables are equal bytes."""

from dataclasses import dataclass

import h5py
import numpy as np

from rupture.replacing import replacing
from data.tables import write_table


@dataclass(frozen=True)
class Column:
    name: str
    unit: str  # 1: a dimensionless number; empty: a text
    cells: list  # texts and numbers of JSON; None where there is none

    @property
    def heading(self):
        return self.name if self.unit in ("", "1") else f"{self.name} [{self.unit}]"

    @property
    def texts(self):
        return [text_of(cell) for cell in self.cells]

    @property
    def numbers(self):
        return np.array([np.nan if cell is None else float(cell) for cell in self.cells])


def text_of(cell):
    if cell is None:
        return ""
    return str(cell).lower() if isinstance(cell, bool) else str(cell)


def write_csv(path, columns):
    rows = zip(*(column.texts for column in columns))
    write_table(path, [column.heading for column in columns], rows)


def text_type(*texts):
    """UTF-8 of the length of the longest one."""
    return h5py.string_dtype("utf-8", max([1, *(len(text.encode()) for text in texts)]))


def array_of(column):
    if column.unit:
        return column.numbers
    return np.array([text.encode() for text in column.texts], text_type(*column.texts))


def set_attribute(item, name, text):
    item.attrs.create(name, text.encode(), dtype=text_type(text))


def write_hdf5(path, title, columns):
    with replacing(path) as part, h5py.File(part, "w") as file:
        set_attribute(file, "title", title)
        for column in columns:
            dataset = file.create_dataset(column.name, data=array_of(column), track_times=False)
            set_attribute(dataset, "unit", column.unit or "1")
