"""The 512-byte header of each file; docs/schema.md."""

import hashlib
import mmap
import os
import stat

from rupture.errors import Failure

HEADER = 512  # [bytes]
CHECKPOINT, RECORD, PART = "rupture-checkpoint", "rupture-record", "rupture-record-part"
WHOLE = "An HDF5 file starts at byte 512; the SHA-256 is that of\ntail -c +513 FILE | sha256sum\n"
WANTED = "give the path of a checkpoint or record"


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
    if kind not in (CHECKPOINT, RECORD, PART):
        raise Failure(f"{path} is not a checkpoint or record of rupture")
    if len(data) < HEADER:
        cut = "it ends within its 512-byte header"
        raise Failure(f"{path} is truncated: {cut}; copy it again or recreate it")
    return kind


def sealed_header(kind, data):
    digest = hashlib.sha256(data[HEADER:]).hexdigest()
    text = f"{kind}\nbytes {len(data)}\nsha256 {digest}\n{WHOLE}"
    return text.encode().ljust(HEADER, b"\n")


def check_seal(data, path):
    """Raises Failure if the bytes of the file are not those that were written."""
    kind = kind_of(data, path)
    if data[:HEADER] != sealed_header(kind, data):
        raise Failure(
            f"{path} is damaged or was changed by another program: its bytes do not match the"
            f" SHA-256 in its header; if it was changed, rupture seal {path} -o NEW.h5 checks and"
            " seals it; otherwise copy it again or recreate it"
        )
