"""Changes of a file: of its bytes, or through HDF5 as other programs make them.

    VERB WORD ...                         of bytes
    edited VERB WORD ... ; VERB WORD ...  through HDF5: the header does not fit any more
    resealed ...                          with a header that fits, as if rupture had made them
    content ...                           with a checksum that fits, too

Words are JSON, or texts as they are.
"""

import json
import os
import re
from pathlib import Path

import h5py
import numpy as np
from h5py import h5d, h5p, h5s, h5t

from commands import run
from rupture.envelope import HEADER, sealed_header

KINDS = {
    "text_of_2_GiB": h5t.C_S1.copy(),
    "text_of_any_length": h5t.C_S1.copy(),
    "compound": h5t.create(h5t.COMPOUND, 8),
    "words": h5t.enum_create(h5t.STD_I64LE),
    "opaque": h5t.create(h5t.OPAQUE, 8),
    "list": h5t.vlen_create(h5t.IEEE_F64LE),
    "pair": h5t.array_create(h5t.IEEE_F64LE, (2,)),
}
KINDS["text_of_2_GiB"].set_size(1 << 31)
KINDS["text_of_2_GiB"].set_strpad(h5t.STR_NULLPAD)
KINDS["text_of_2_GiB"].set_cset(h5t.CSET_UTF8)
KINDS["text_of_any_length"].set_size(h5t.VARIABLE)
KINDS["compound"].insert(b"member", 0, h5t.IEEE_F64LE)
KINDS["words"].enum_insert(b"zero", 0)
SPACE = h5s.create_simple((4, 5))
STORAGE: dict = {
    "chunked": {"chunk": [(2, 5)]},
    "compressed": {"chunk": [(2, 5)], "deflate": [9]},
    "external": {"external": [b"/dev/zero", 0, 160]},
    "virtual": {"virtual": [SPACE, b"other.h5", b"/x", SPACE]},
    "of_itself": {"virtual": [SPACE, b".", b"/state/u_x", SPACE]},
}


def sealed(data):
    """With a header that fits, as if rupture had written them."""
    kind = data.split(b"\n")[0].decode()
    return sealed_header(kind, data) + data[HEADER:]


OF_BYTES: dict = {
    "flip": lambda data, at: data[:at] + bytes([data[at] ^ 1]) + data[at + 1 :],
    "resealed_byte": lambda data, at, value: sealed(data[:at] + bytes([value]) + data[at + 1 :]),
    "first": lambda data, size: data[:size],
    "behind": lambda data, start, end=None: data[start:end],
    "filled": lambda data, text, times=1: times * text.encode(),
    "extended": lambda data, text: data + text.encode(),
    "repeated": lambda data, size: data + data[:size],
}
OF_PATHS: dict = {
    "none": lambda path: None,
    "folder": os.mkdir,
    "device": lambda path: os.symlink("/dev/null", path),
    "empty_hdf5": lambda path: h5py.File(path, "w").close(),
}


def as_written(value):
    """A text has a fixed length in a file."""
    if not isinstance(value, str):
        return {"data": value, "dtype": None}
    data = value.encode(errors="surrogateescape") or b"\0"
    return {"data": data, "dtype": h5py.string_dtype("utf-8", len(data))}


def attribute(file, path, name, value, kind=None):
    file[path].attrs.create(name, **({"data": value, "dtype": kind} if kind else as_written(value)))


def put(file, path, value, unit=None):
    """A dataset of this value, with the unit that it had if there was one."""
    was = file.pop(path, None)
    file.create_dataset(path, **as_written(value))
    attribute(file, path, "unit", unit or (was.attrs["unit"].decode() if was else "1"))


def element(file, path, index, value):
    values = np.array(file[path])
    values.flat[index] = value
    file[path][()] = values


def scaled(file, path, index, factor):
    element(file, path, index, factor * np.array(file[path]).flat[index])


def stored(file, path, kind, shape, storage=""):
    """A dataset without values or unit; the shape may be SCALAR or NULL."""
    file.pop(path, None)
    properties = h5p.create(h5p.DATASET_CREATE)
    for name, arguments in STORAGE.get(storage, {}).items():
        getattr(properties, f"set_{name}")(*arguments)
    is_list = isinstance(shape, list)
    space = h5s.create_simple(tuple(shape)) if is_list else h5s.create(getattr(h5s, shape))
    h5d.create(file.id, path.encode(), KINDS.get(kind) or getattr(h5t, kind), space, properties)


def repacked(file, path, kind="f8", packer=9):
    """Compressed and without unit."""
    file.create_dataset(path, data=file.pop(path)[()], dtype=kind, chunks=True, compression=packer)


def many_ways(file):
    """Seven groups, each of which holds the next one a hundred times: 10^14 ways to the last."""
    for depth in range(7):
        group = file.create_group(f"g{depth}")
        for n in range(100 if depth else 0):
            group[str(n)] = file[f"g{depth - 1}"]


def without(file, path, name=None):
    """The object or its attribute."""
    del (file[path].attrs if name else file)[name or path]


OF_HDF5: dict = {
    "attribute": attribute,
    "put": put,
    "element": element,
    "scaled": scaled,
    "stored": stored,
    "repacked": repacked,
    "without": without,
    "many_ways": many_ways,
    "comment": lambda file: file.attrs.__setitem__("comment", "mine"),
    "hard_link": lambda file, to, path: file.__setitem__(path, file[to]),
    "soft_link": lambda file, to, path: file.__setitem__(path, h5py.SoftLink(to)),
    "external_link": lambda file, to, path: file.__setitem__(path, h5py.ExternalLink(to, "/")),
    "named_type": lambda file, path: file.__setitem__(path, np.dtype("f8")),
}


def words_of(line):
    """Values of JSON, or texts."""
    for word in re.findall(r'"(?:[^"\\]|\\.)*"|\S+', line):
        try:
            yield json.loads(word)
        except ValueError:
            yield word


def edit(path, changes):
    with h5py.File(path, "r+") as file:
        for line in changes.split(" ; "):
            verb, *words = words_of(line)
            OF_HDF5[verb](file, *words)


def reseal(path, changes):
    edit(path, changes)
    path.write_bytes(sealed(path.read_bytes()))


def change(path, line):
    path, (verb, _, rest) = Path(path), line.partition(" ")
    if verb in OF_PATHS:
        path.unlink()
        OF_PATHS[verb](path)
    elif verb in OF_BYTES:
        path.write_bytes(OF_BYTES[verb](path.read_bytes(), *words_of(rest)))
    elif verb == "edited":
        edit(path, rest)
    else:
        assert verb in ("resealed", "content")
        reseal(path, rest)
        said = run(["analyze", "checksum", path]).err
        sums = re.search(r"its content has the checksum (\w+), but", said)
        if verb == "content" and sums:
            reseal(path, f"attribute / content_checksum {sums[1]}")
