"""The list of what was written below results/, a path in each line: ./reproduce.sh clean deletes
these files alone, and a report replaces no others."""

import os
from pathlib import Path

from rupture.errors import Failure

LIST = ".rupture-files"
known: dict[Path, set[str]] = {}  # by folder: what this process has read or noted


def written(results):
    """Paths relative to `results`. A link in the place of the list is not followed."""
    path = results / LIST
    if path.is_symlink() or not path.exists():
        return set()
    return set(path.read_text(encoding="utf-8", errors="surrogateescape").splitlines())


def append_to(path):
    """Opens a file of ours at its end, and follows no link in its place."""
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW
    return open(os.open(path, flags, 0o666), "w", encoding="utf-8")


def note(results, *paths):
    """Call it before the files are written, so that those of a killed run are known, too."""
    folder = Path(results).resolve()
    have = known.setdefault(folder, written(folder))
    names = dict.fromkeys(str(path).removeprefix(f"{results}/") for path in paths)
    if new := [name for name in names if name not in have]:
        folder.mkdir(parents=True, exist_ok=True)
        with append_to(folder / LIST) as file:
            file.write("".join(f"{name}\n" for name in new))
        have.update(new)


def refuse_others(results, *paths):
    """Raises Failure if one of these files exists below `results` and is not ours."""
    ours = written(results)
    for path in filter(os.path.lexists, paths):
        if str(path).removeprefix(f"{results}/") not in ours or path.is_symlink():
            raise Failure(
                f"{path} is not in {results}/{LIST} and is not replaced: move it away, and all of"
                f" {results} if an earlier version wrote it"
            )


def take(results, *paths):
    """Notes files as ours, if no others are there."""
    refuse_others(results, *paths)
    note(results, *paths)
