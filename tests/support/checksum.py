"""The content checksum of a file as docs/schema.md defines it, independent of the programs:

    python3 checksum.py FILE
"""

import hashlib
import struct
import sys

import h5py
import numpy as np

GROUP = "/parameters/junctions/"
DEFAULTS: dict[str, bytes | float] = {
    "t_R": 2e-3,
    "delta_t_R": 6e-4,
    "slipping_times": b"gaussian",
    "f_new": b"zero",
    "mu_new": 0.119,
    "v_slow": 1.5e-3,
}
USED = {
    b"reference": ["t_R", "delta_t_R", "slipping_times", "f_new", "without_contact"],
    b"simplified": ["t_R", "v_slow"],
    b"decaying": ["t_R", "delta_t_R", "slipping_times", "mu_new", "without_contact", "repin"],
    b"distance": ["d_R", "delta_d_R", "f_new", "without_contact"],
}
LATER: dict = {  # count only where the law uses them and away from their defaults
    "d_R": 1e-6,
    "delta_d_R": 3e-7,
    "k_ij_from": b"current",
    "without_contact": b"follow",
    "repin": b"as_is",
    "/parameters/slider/foundation_damping": 0.0,
    "/parameters/slider/load": 1.0,
    "/parameters/slider/springs": b"exact",
    "/parameters/slider/edge_springs": b"full",
    "/parameters/slider/damping_along": b"velocity",
}
OF_LAWS = {name for names in USED.values() for name in names}  # all laws use the others
CONTENT = ("parameters", "state", "series", "ruptures", "crossings", "fields")


def counts(path, value, law):
    name = path.removeprefix(GROUP)
    if path.split("/")[1] not in CONTENT or path.split("/")[-1] in ("x", "z"):
        return False  # positions follow from the parameters
    used = name in USED[law] or name not in OF_LAWS
    return name not in LATER or used and not np.array_equal(value, LATER[name])


def u64(number):
    return struct.pack("<Q", number)


def prefixed(data):
    return u64(len(data)) + data


def content(dataset, law):
    """Type and bytes of a dataset as they count."""
    name, value, kind = dataset.name.removeprefix(GROUP), dataset[()], dataset.dtype.name
    if name in DEFAULTS and name not in USED[law]:
        value = DEFAULTS[name] if isinstance(DEFAULTS[name], bytes) else np.float64(DEFAULTS[name])
    elif dataset.dtype.kind == "S":  # numpy drops the padding of a text, which counts
        value = value.ljust(dataset.dtype.itemsize, b"\0")
    return (b"text", value) if isinstance(value, bytes) else (kind.encode(), value.tobytes())


def checksum(file):
    law = file[GROUP + "law"][()]
    digest = hashlib.sha256(b"rupture content 1\n")
    paths: list[str] = []
    file.visit(paths.append)
    for path in sorted(f"/{path}" for path in paths):  # all of them are ASCII
        dataset = file[path]
        if isinstance(dataset, h5py.Dataset) and counts(path, dataset[()], law):
            kind, raw = content(dataset, law)
            digest.update(prefixed(path.encode()) + prefixed(kind))
            is_default = len(raw) != dataset.nbytes  # one in place of many
            shape = () if is_default else dataset.shape
            digest.update(u64(len(shape)) + b"".join(map(u64, shape)) + prefixed(raw))
    return digest.hexdigest()


if __name__ == "__main__":
    with h5py.File(sys.argv[1], "r") as given:
        print(checksum(given))
