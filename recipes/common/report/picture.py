"""The pictures and the movie of the page: sizes and formats."""

import struct
from dataclasses import dataclass

from rupture.errors import Failure

VIDEOS = {"movie.webm": "video/webm", "movie.mp4": "video/mp4"}
ANIMATION = "movie.gif"
STILL = "movie.png"  # shown before a video is started


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


def find_movie(results):
    """The one in results/, whoever has made it; None if there is none. Of the videos, which have a
    name and a type, the preferred one comes first."""
    videos = [(name, kind) for name, kind in VIDEOS.items() if (results / name).exists()]
    animation, still = (n if (results / n).exists() else None for n in (ANIMATION, STILL))
    found = {"videos": videos, "animation": animation, "still": still}
    return found if videos or animation else None
