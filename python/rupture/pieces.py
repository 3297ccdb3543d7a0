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


def joined(data):
    """An open h5py.File with what the bytes of a `.part` hold, in time linear in their size. The
    first piece has all datasets, later ones further rows of some of them."""
    whole = h5py.File(io.BytesIO(), "w")
    rows: dict[str, list] = defaultdict(list)
    units: dict = {}
    for piece in pieces(data):
        with h5py.File(io.BytesIO(piece), "r") as file:
            whole.attrs.update({"format": PART, "schema_version": file.attrs["schema_version"]})
            for path, item in datasets(file).items():
                if item.ndim:
                    rows[path].append(item[()])
                    units.setdefault(path, item.attrs.get("unit"))
                else:
                    file.copy(item, whole, path)
    for path, parts in rows.items():
        dataset = whole.create_dataset(path, data=np.concatenate(parts))
        if units[path] is not None:
            dataset.attrs["unit"] = units[path]
    return whole
