"""The pictures and the movie of the page: sizes and formats. That of all claims is drawn anew if
that would change it: to load Matplotlib and to draw takes longer than all the rest of the page."""

import hashlib
import json
import struct
from dataclasses import dataclass
from pathlib import Path

from rupture.errors import Failure

VIDEOS = {"movie.webm": "video/webm", "movie.mp4": "video/mp4"}
ANIMATION = "movie.gif"
STILL = "movie.png"  # shown before a video is started, and on paper

GLANCE = (
    "A row per claim, figure by figure. Left: for which share of its units it holds, and whether it"
    " holds for the shown case; right: the share under each convention that several claims have,"
    " and the least under others."
)
COMMON = Path(__file__).resolve().parents[1]
DRAWN_BY = ("report/glance.py", "pictures/plotting.py", "claims/judge.py", "claims/claims.toml")


@dataclass(frozen=True)
class Picture:
    name: str
    pdf: str | None
    width: int  # [pixels]
    height: int
    alt: str  # for those who do not see it; the caption says more


def picture(path, alt):
    """Width and height stand in a PNG after its signature and the name of the first chunk."""
    with open(path, "rb") as file:
        head = file.read(24)
    if len(head) < 24 or head[12:16] != b"IHDR":
        raise Failure(f"{path} is no PNG: delete it and run ./reproduce.sh {path.parent.name}.")
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


def source_of(claims):
    """A digest of all that it shows, and of what draws it."""
    shown = json.dumps([(claim.id, claim.shown, claim.shares) for claim in claims], default=vars)
    parts = [shown.encode(), *((COMMON / path).read_bytes() for path in DRAWN_BY)]
    return hashlib.sha256(b"".join(parts)).hexdigest()


def glance_picture(root, claims):
    """None without any claim over units."""
    found = [claim for claim in claims if claim.shares]
    if not found:
        return None
    stem, source = root / "results/claims", source_of(found)
    png, pdf = stem.with_suffix(".png"), stem.with_suffix(".pdf")
    if not (pdf.exists() and png.exists() and source.encode() in png.read_bytes()):
        from glance import draw_glance  # here, because it loads Matplotlib

        draw_glance(found, stem, source)
    return picture(png, GLANCE)
