"""The 512-byte header of each file and of each piece of a `.part`, and the pieces as one file in
memory; docs/schema.md."""

import hashlib
import io
import mmap
import os
import re
import stat
from collections import defaultdict

import h5py
import numpy as np

from rupture.errors import Failure
from rupture.layout import Content

HEADER = 512  # [bytes]
CHECKPOINT, RECORD, PART = "rupture-checkpoint", "rupture-record", "rupture-record-part"
WHOLE = "An HDF5 file starts at byte 512; the SHA-256 is that of\ntail -c +513 FILE | sha256sum\n"
PIECE = (
    "One of the pieces of an unfinished record, which follow each other in this file.\n"
    "An HDF5 file starts at byte 512 of each.\n"
)
WANTED = "give the path of a checkpoint or record"
ROWS = re.compile(r"\[\d+\]")
EXPLANATIONS = {CHECKPOINT: WHOLE, RECORD: WHOLE, PART: PIECE}


def mapped(path):
    """The bytes of a file, as they are now, without a copy."""
    try:
        if not os.fspath(path):
            raise Failure(f"the name of an input is empty; {WANTED}")
        about = os.stat(path)  # before it is opened: a pipe would wait for its other end
        mode = about.st_mode
        if stat.S_ISDIR(mode):
            raise Failure(f"{path} is a folder; {WANTED}")
        if not stat.S_ISREG(mode):
            raise Failure(f"{path} is not a regular file; {WANTED}")
        if not about.st_size:
            raise Failure(f"{path} is empty; expected a checkpoint or record")
        with open(path, "rb") as file:
            return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    except (FileNotFoundError, NotADirectoryError):
        part = f" yet, but {path}.part does" if os.path.exists(f"{path}.part") else ""
        raise Failure(f"{path} does not exist{part}; {WANTED}") from None
    except (TypeError, ValueError) as error:
        raise Failure(f"{path!r} is not the name of a file: {error}; {WANTED}") from None
    except OSError as error:
        hint = "check the permissions of the file and its folder"
        raise Failure(f"cannot read {path}: {error.strerror}; {hint}") from None


def kind_of(data, path):
    """First line of the header."""
    kind = bytes(data[:HEADER]).split(b"\n")[0].decode("latin-1")
    if kind not in EXPLANATIONS:
        raise Failure(f"{path} is not a checkpoint or record of rupture")
    if len(data) < HEADER:
        cut = "it ends within its 512-byte header"
        raise Failure(f"{path} is truncated: {cut}; copy it again or recreate it")
    return kind


def sealed_header(kind, data):
    digest = hashlib.sha256(data[HEADER:]).hexdigest()
    text = f"{kind}\nbytes {len(data)}\nsha256 {digest}\n{EXPLANATIONS[kind]}"
    return text.encode().ljust(HEADER, b"\n")


def is_intact(kind, data):
    return data[:HEADER] == sealed_header(kind, data)


def check_seal(data, path):
    """The kind of the file; a Failure if its bytes are not those that were written."""
    kind = kind_of(data, path)
    whole = next(pieces(data), b"") if kind == PART else is_intact(kind, data)
    if not whole:
        raise Failure(
            f"{path} is damaged or was changed by another program: its bytes do not match the"
            f" SHA-256 in its header; if it was changed, rupture seal {path} -o NEW.h5 checks and"
            " seals it; otherwise copy it again or recreate it"
        )
    return kind


def stated_size(header):
    """The size that the header states [bytes]; 0 if it states none."""
    found = re.match(rb".*\nbytes (\d+)\n", header)
    return int(found[1]) if found else 0


def pieces(data):
    """The pieces of a `.part`, up to the first that is not intact."""
    start = 0
    while HEADER < (size := stated_size(data[start : start + HEADER])) <= len(data) - start:
        piece = data[start : start + size]
        if not is_intact(PART, piece):
            return
        yield piece
        start += size


def joined(data, path):
    """An open h5py.File with what the bytes of a `.part` hold, and its Content, in time linear in
    their size. The first piece has all datasets, later ones further rows of some of them."""
    whole = h5py.File(io.BytesIO(), "w")
    rows: dict[str, list] = defaultdict(list)
    units: dict = {}
    first: dict = {}
    for piece in pieces(data):
        with h5py.File(io.BytesIO(piece), "r") as file:
            content = Content(file, path, PART, len(piece))
            first = first or content
            whole.attrs.update({"format": PART, "schema_version": file.attrs["schema_version"]})
            for name, form in content.items():
                if ROWS.sub("[]", first.get(name, ""), 1) != ROWS.sub("[]", form, 1):
                    content.fail(f"{name} does not continue that of the first piece")
                if (item := file[name]).ndim:
                    rows[name].append(item[()])
                    units.setdefault(name, item.attrs["unit"])
                else:
                    file.copy(item, whole, name)
    for name, parts in rows.items():
        dataset = whole.create_dataset(name, data=np.concatenate(parts))
        dataset.attrs["unit"] = units[name]
        first[name] = ROWS.sub(f"[{len(dataset)}]", first[name], 1)
    return whole, first
