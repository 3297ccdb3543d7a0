"""results/claims.png, all claims at a glance (glance.py). It is drawn anew if that would change it:
to load Matplotlib and to draw takes longer than all the rest of the page."""

import hashlib
import json
from pathlib import Path

from picture import picture

GLANCE = (
    "Above, for which share of its units each claim holds under each convention, from the smallest"
    " to the largest, and whether it holds for the shown case; below, which convention that is."
)
COMMON = Path(__file__).resolve().parents[1]
DRAWN_BY = ("report/glance.py", "pictures/plotting.py", "claims/judge.py", "claims/claims.toml")


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
