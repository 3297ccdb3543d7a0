"""Results of points that have been computed: results/data/points/ID.json.

Beside the result such a file has its `origin`: a digest of the sources (or programs), of point.py
and of the base that it was computed with. A point whose file has another one is computed again.
While a point could not be computed because its process crashed, ID.why says how.
"""

import hashlib
import json
from functools import cache
from pathlib import Path

from rupture.replacing import write_whole


COMPUTED_BY = Path(__file__).with_name("point.py").read_text(encoding="utf-8")


def digest(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


@cache
def content_of(base):
    """The identity of a base: the checksum of their content, or else of their bytes."""
    if not base:
        return ""
    checksum = Path(f"{base}.sum")
    if checksum.exists():
        return checksum.read_text(encoding="utf-8")
    return hashlib.sha256(Path(base).read_bytes()).hexdigest()


class PointStore:
    def __init__(self, folder, code):
        """`code`: fingerprint of the sources or programs."""
        self.folder = Path(folder)
        self.code = code

    def path(self, point):
        return self.folder / f"{point.id}.json"

    def origin(self, point):
        return digest(self.code, COMPUTED_BY, content_of(point.base))

    def result(self, point):
        """The result of the point; None if it has to be computed."""
        try:
            stored = json.loads(self.path(point).read_text(encoding="utf-8"))
            is_current = stored.pop("origin", None) == self.origin(point)
        except (OSError, ValueError, AttributeError, TypeError):
            return None
        return stored if is_current else None

    def save(self, point, result):
        content = json.dumps({**result, "origin": self.origin(point)}) + "\n"
        write_whole(self.path(point), content)
        self.note_crash(point, "")

    def note_crash(self, point, sentence):
        """Why the point is unfinished; an empty sentence if it is not."""
        path = self.folder / f"{point.id}.why"
        if sentence:
            write_whole(path, f"{sentence}\n")
        else:
            path.unlink(missing_ok=True)

    def crash(self, point):
        path = self.folder / f"{point.id}.why"
        return path.read_text(encoding="utf-8").strip() if path.exists() else ""
