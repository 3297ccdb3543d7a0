"""./reproduce.sh clean: deletes what was written and built here, and lists what it leaves."""

import os
import shutil

from reproduce.project import READ, ROOT, SHARE, WORK, say
from runs.written import LIST, written

HOME = (WORK or ROOT).resolve()
RESULTS = HOME / "results"
OWN = HOME / ROOT.relative_to(WORK) if WORK else ROOT  # has build/ and Snakemake's files
BUILD = OWN / "build"
NAMED = 20  # of the files that are left


def own_files():
    """Those of the list, which may be anybody's, that lie in results/ and behind no link."""
    listed = [RESULTS / name for name in (*written(RESULTS), LIST)]
    return [one for one in listed if RESULTS in one.parents and one.resolve() == one]


def own_folders():
    """Those of runs, and builds of these sources; behind no link either."""
    home = f"\nCMAKE_HOME_DIRECTORY:INTERNAL={SHARE}\n"
    caches = [*BUILD.glob("CMakeCache.txt"), *BUILD.glob("*/CMakeCache.txt")]
    builds = [one.parent for one in caches if home in one.read_text(errors="replace")]
    found = [OWN / ".snakemake", BUILD / "log", BUILD / "cache", *builds]
    return [one for one in found if one.resolve() == one and one.is_dir()]


def own_links():
    """With which `rupture reproduce` shows the recipes their folder; and the locks, at the end."""
    links = [OWN / name for name in ("results", *READ)] if WORK else []
    return [*filter(os.path.islink, links), *BUILD.glob(".lock*")]


def left_in(path):
    """Files and links. Folders without any are deleted."""
    if path.is_symlink() or not path.is_dir():
        return [path] if os.path.lexists(path) else []
    left = [each for one in sorted(path.iterdir()) for each in left_in(one)]
    if not left:
        path.rmdir()
    return left


def say_left(left):
    say("Kept (links are not followed, and this program did not write the other files):")
    for path in left[:NAMED]:
        target = f" -> {os.readlink(path)}" if path.is_symlink() else ""
        say(f"  {path.relative_to(HOME)}{target}")
    if len(left) > NAMED:
        say(f"  and {len(left) - NAMED} more")


def clean(*_):
    files = [one for one in own_files() if one.is_file()]
    folders = own_folders()
    files_in = f"{len(files) - 1} file{'s' if len(files) > 2 else ''} in results/"
    deleted = [files_in] if len(files) > 1 else []
    deleted += [f"{one.relative_to(HOME)}/" for one in folders if any(one.iterdir())]
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=not folder.exists())  # within another
    for file in [*files, *own_links()]:
        file.unlink()
    places = (RESULTS, OWN) if WORK else (RESULTS, OWN / ".snakemake", BUILD)
    left = [path for place in places for path in left_in(place)]
    say(f"Deleted {', '.join(deleted)}." if deleted else "Nothing was deleted.")
    if left:
        say_left(left)
