"""The pieces of a `.part` as one file in memory."""

import io
from collections import defaultdict

import h5py
import numpy as np

from rupture.envelope import PART, pieces


def datasets(group):
    """All datasets in a file or group, by path."""
    found = {}

    def keep(path, item):
        if isinstance(item, h5py.Dataset):
            found[path] = item

    group.visititems(keep)
    return found


def copy_first(piece, whole, rows):
    """Copies what has no rows; those of all other datasets go to `rows`."""
    for path, item in datasets(piece).items():
        if item.ndim == 0:
            piece.copy(item, whole, path)
        else:
            rows[path].append(item[()])


def add_rows(piece, rows):
    for path, parts in rows.items():
        if path in piece:
            parts.append(piece[path][()])


def write_rows(first, whole, rows):
    for path, parts in rows.items():
        dataset = whole.create_dataset(path, data=np.concatenate(parts))
        if "unit" in first[path].attrs:
            dataset.attrs["unit"] = first[path].attrs["unit"]


def joined(data):
    """An open h5py.File with what the bytes of a `.part` hold, in time linear in their size."""
    whole = h5py.File(io.BytesIO(), "w")
    whole.attrs["format"] = PART
    rows: dict[str, list] = defaultdict(list)
    opened = (h5py.File(io.BytesIO(piece), "r") for piece in pieces(data))
    first = next(opened)
    whole.attrs["schema_version"] = first.attrs["schema_version"]
    copy_first(first, whole, rows)
    for piece in opened:
        with piece:
            add_rows(piece, rows)
    write_rows(first, whole, rows)
    first.close()
    return whole
