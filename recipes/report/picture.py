"""The pictures of the page: sizes and formats."""

import struct
from dataclasses import dataclass

from rupture.errors import Failure

MOVIE = "fig2/movie.gif"  # of a slow front; the page begins with it


@dataclass(frozen=True)
class Picture:
    name: str
    pdf: str | None
    width: int  # [pixels]
    height: int
    alt: str  # what is seen, in words


def picture(path, alt):
    """Width and height stand in a PNG after its signature and the name of the first chunk."""
    with open(path, "rb") as file:
        head = file.read(24)
    if len(head) < 24 or head[12:16] != b"IHDR":
        raise Failure(f"{path} is not a PNG: delete it and run ./reproduce.sh {path.parent.name}.")
    width, height = struct.unpack(">II", head[16:24])
    pdf = path.with_suffix(".pdf")
    return Picture(path.name, pdf.name if pdf.exists() else None, width, height, alt)
