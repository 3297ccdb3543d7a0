"""Results of points on the disk, as far as they need no more than their names: in
results/data/points, ID.json with the result, ID.origin with what it was computed from, and ID.FILE
for each file that the point keeps. It imports little, because each point does."""

import json
import os
from contextlib import suppress
from pathlib import Path

from report.written import take
from rupture.commands.code import digest, digest_at, path_of, stamp_of
from rupture.replacing import replacing, write_whole

RESULTS = Path("results")
STORE = RESULTS / "data/points"
SPARE = RESULTS / "data/spare"  # files of finished points while others of their batch run
DIGESTS = RESULTS / "data/digests"  # of what programs compute with
FORM = "1"  # of results; another one makes all points stale


def read(path):
    """The text of a file; nothing if there is none, or none that can be read as text."""
    with suppress(OSError, ValueError):
        return Path(path).read_text(encoding="utf-8")
    return ""


def write_if_changed(path, text):
    """Leaves a file that says so, and its date, alone: then nothing after it is stale."""
    if read(path) != text:
        write_whole(path, text)


def write_own(path, content):
    """Bytes of a file that is ours, or none yet; one that is equal keeps its date."""
    take(RESULTS, path)
    if not path.exists() or path.read_bytes() != content:
        with replacing(path) as part:
            part.write_bytes(content)


def result_of(path):
    return json.loads(Path(path).read_text(encoding="utf-8"))


def tools_of(commands):
    """Names of the programs that a point runs."""
    return sorted({line.split()[0] for line in commands})


def digest_file(tool):
    """Where the digest of what it computes with is."""
    return DIGESTS / tool


def digest_of_tool(tool):
    path = path_of(tool)
    return digest_at(path, stamp_of(path))


def content_of(base):
    """A digest of the file that a point starts from; of one that a point kept, the checksum of its
    content."""
    if base and base["of"]:
        return result_of(base["of"])["checksums"].get(base["shown"], "")
    return digest(Path(base["file"]).read_bytes()) if base else ""


def sources_of(work):
    """The files with the reports of other points that its commands name."""
    sources = (source for source in work["names"].values() if isinstance(source, str))
    return [source for source in sources if not source.startswith("{")]


def origin_of(work, programs):
    """What a result comes from: the point's work, digests of the programs, and the contents of its
    files."""
    reports = map(read, sources_of(work))
    return digest(FORM, json.dumps(work), content_of(work["base"]), *programs, *reports)


def make_spare(*files):
    """Other names for files which Ninja deletes if it is interrupted before the batch has ended."""
    SPARE.mkdir(exist_ok=True)
    for file in files:
        with suppress(OSError):  # some file systems have no links
            os.link(file, SPARE / file.name)


def put_back():
    """What Ninja has deleted; nobody needs the other spare files any more."""
    for spare in SPARE.glob("*"):
        file = STORE / spare.name
        spare.unlink() if file.exists() else spare.rename(file)


def is_current(path, origin=""):
    """Whether a result is as it was written, and was computed from `origin`."""
    written = read(path.with_suffix(".origin"))
    return written.startswith(origin) and written.endswith(f" {digest(read(path))}")


def save_origin(path, origin):
    write_whole(path.with_suffix(".origin"), f"{origin} {digest(read(path))}")
