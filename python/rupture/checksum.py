"""The content checksum of a checkpoint or record, as docs/schema.md defines it:

    python3 checksum.py FILE
"""

import hashlib
import struct
import sys

import h5py

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
LATER = {  # count only where the law uses them and away from their defaults
    "d_R": 1e-6,
    "delta_d_R": 3e-7,
    "k_ij_from": b"current",
    "without_contact": b"follow",
    "repin": b"as_is",
    "/parameters/slider/foundation_damping": 0.0,
    "/parameters/slider/springs": b"exact",
}
OF_LAWS = {name for names in USED.values() for name in names}  # all laws use the others
CONTENT = ("parameters", "state", "series", "ruptures", "crossings", "fields")


def counts(path, dataset, law):
    name = path.removeprefix(GROUP)
    if name not in LATER:
        return True
    used = law is not None and (name in USED[law] or name not in OF_LAWS)
    return used and dataset[()] != LATER[name]


def datasets(group):
    """All datasets in a file or group, by path."""
    found = {}

    def keep(path, item):
        if isinstance(item, h5py.Dataset):
            found[path] = item

    group.visititems(keep)
    return found


def is_content(path):
    """Positions are left out: they follow from the parameters."""
    return path.split("/")[0] in CONTENT and path.split("/")[-1] not in ("x", "z")


def u64(number):
    return struct.pack("<Q", number)


def prefixed(data):
    return u64(len(data)) + data


def content(dataset, law):
    """Type and bytes of a dataset as they count."""
    name = dataset.name.removeprefix(GROUP)
    if name in DEFAULTS and law is not None and name not in USED[law]:
        by_default = DEFAULTS[name]
        is_text = isinstance(by_default, bytes)
        return (b"text", by_default) if is_text else (b"float64", struct.pack("<d", by_default))
    value = dataset[()]
    if dataset.dtype.kind == "S":  # numpy drops the padding of a text, whose length is of its type
        return b"text", value.ljust(dataset.dtype.itemsize, b"\0")
    return dataset.dtype.name.encode(), value.tobytes()


def content_checksum(file):
    """64 hexadecimal digits; `file` is an open h5py.File."""
    law = file[GROUP + "law"][()] if file.attrs["schema_version"] > 2 else None  # as they are
    own = {f"/{path}": item for path, item in datasets(file).items() if is_content(path)}
    digest = hashlib.sha256(b"rupture content 1\n")
    for path, dataset in sorted(own.items(), key=lambda one: one[0].encode()):
        if not counts(path, dataset, law):
            continue
        kind, raw = content(dataset, law)
        digest.update(prefixed(path.encode()))
        digest.update(prefixed(kind))
        digest.update(u64(len(dataset.shape)) + b"".join(map(u64, dataset.shape)))
        digest.update(prefixed(raw))
    return digest.hexdigest()


if __name__ == "__main__":
    with h5py.File(sys.argv[1], "r") as given:
        print(content_checksum(given))
