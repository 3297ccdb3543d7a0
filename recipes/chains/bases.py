"""Copies of the files from which points of users' sweeps start, named after their content."""

from rupture.errors import Failure, UsageError
from rupture.programs import output_of
from rupture.replacing import replacing
from reproduce.written import take


def write(results, path, content):
    """Leaves a file with this content, and its date, alone."""
    take(results, path)
    if path.exists() and path.read_bytes() == content:
        return
    with replacing(path) as part:
        part.write_bytes(content)


def keep_base(path, results):
    """Makes the copy, with its .sum."""
    try:
        checksum = output_of("analyze", "checksum", path).strip()
    except Failure as failure:
        said = str(failure).removeprefix("analyze: ")
        raise UsageError(f"the base cannot be used: {said}") from None
    content = path.read_bytes()
    if not content.startswith(b"rupture-checkpoint\n"):
        raise UsageError(f"the base {path} is a record; runs continue from checkpoints")
    copy = results / "data/bases" / f"{checksum[:16]}.h5"
    write(results, copy, content)
    line = f"content-sha256 {checksum}  {copy.name}\n"
    write(results, copy.with_name(f"{copy.name}.sum"), line.encode())
    return copy
