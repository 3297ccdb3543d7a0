"""./reproduce.sh clean: deletes what was written and built here, and lists what it leaves."""

import os
import shutil
from contextlib import suppress
from pathlib import Path

from reproduce.project import READ, ROOT, WORK, say
from reproduce.stamps import ASKED, NEEDS
from report.written import FORMER, MARKER, is_below, written
from rupture.commands.store import MARKER as OF_STORE, Store
from rupture.commands.folder import read_own
from rupture.errors import Failure
from rupture.tools.command_line import in_one_line, plural

HOME = (WORK or ROOT).resolve()
RESULTS = HOME / "results"
STORE = RESULTS / "store"
OWN = HOME / ROOT.relative_to(WORK) if WORK else ROOT  # has build/
BUILD = OWN / "build"
NAMED = 20  # of the files that are left


def own_files():
    """The listed files in results/ that are not behind links, and then the list. Anybody may have
    written it."""
    if MARKER.is_in(RESULTS):
        names = [*written(RESULTS), MARKER.name]
    else:
        former = read_or(RESULTS / FORMER).splitlines()
        names = [*filter(is_below, former), *([FORMER] if former else [])]
    listed = [RESULTS / name for name in names]
    return [*filter(is_here, listed)]


def is_here(path):
    """Whether it is not behind a link."""
    return os.path.realpath(path) == str(path)


def read_or(path):
    """The text of a file; nothing of a link, a pipe, or if there is none."""
    with suppress(OSError):
        return read_own(path).decode(errors="surrogateescape")
    return ""


def own_folders():
    """The folders of runs, and of builds of rupture; not behind links either."""
    name = "\nCMAKE_PROJECT_NAME:STATIC=rupture\n"  # wherever the sources were at that time
    caches = [*BUILD.glob("CMakeCache.txt"), *BUILD.glob("*/CMakeCache.txt")]
    builds = [one.parent for one in caches if name in read_or(one)]
    found = [BUILD / "log", BUILD / "cache", *builds]
    return [one for one in found if is_here(one) and one.is_dir()]


def own_links():
    """The links through which recipes of `rupture reproduce` find their files, then locks."""
    links = [OWN / name for name in ("results", *READ)] if WORK else []
    locks = [BUILD / ".lock-of-programs", BUILD / ".lock"]  # one of 0.5, and that of this run
    return [*filter(os.path.islink, links), *filter(os.path.lexists, locks)]


def left_in(place):
    """The files and links in a place."""
    if place.is_symlink() or not place.is_dir():
        return [place] if os.path.lexists(place) else []
    return [one for one in sorted(place.rglob("*")) if one.is_symlink() or not one.is_dir()]


def say_left(left):
    say("Kept (links are not followed, and this program did not write the other files):")
    for path in left[:NAMED]:
        target = f" -> {os.readlink(path)}" if path.is_symlink() else ""
        say(in_one_line(f"  {path.relative_to(HOME)}{target}"))
    if len(left) > NAMED:
        say(f"  and {len(left) - NAMED} more")


def delete_store():
    """What commands have found; not behind a link. Returns whether there was any."""
    is_ours = is_here(STORE) and OF_STORE.is_in(STORE)
    if is_ours:
        OF_STORE.check(STORE)
        lock = OF_STORE.lock(STORE)  # it goes last
        for folder in filter(Path.is_dir, STORE.iterdir()):
            shutil.rmtree(folder)
        shutil.rmtree(STORE)
        lock.close()
    return is_ours


def clean(request, _):
    if request.unneeded:
        clean_unneeded()
    else:
        clean_all()


def clean_all():
    lock = MARKER.lock(RESULTS) if is_here(RESULTS) and MARKER.is_in(RESULTS) else None
    listed = own_files()
    files = [one for one in listed if one.is_file()]
    folders = own_folders()
    files_in = f"{len(files) - 1} file{'s' if len(files) > 2 else ''} in results/"
    deleted = [files_in] if len(files) > 1 else []
    deleted += [f"{one.relative_to(HOME)}/" for one in folders if any(one.iterdir())]
    deleted += ["results/store/"] if delete_store() else []
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=not folder.exists())  # within another
    links = own_links()
    for file in files + links:
        file.unlink(missing_ok=True)
    parents = {parent for one in [*listed, *folders, *links, STORE] for parent in one.parents}
    for folder in sorted(parents, reverse=True):  # what is in a folder comes first
        with suppress(OSError):
            if HOME in folder.parents:
                folder.rmdir()
    places = (RESULTS, OWN) if WORK else (RESULTS, BUILD)
    left = [path for place in places for path in left_in(place)]
    say(f"Deleted {', '.join(deleted)}." if deleted else "Nothing was deleted.")
    if left:
        say_left(left)
    if lock:
        lock.close()


# --- results that no recipe has asked for last time ---------------------------------------------


def needed(store):
    """Ids of commands. Raises Failure if a recipe was not finished, so that one cannot know."""
    found = set()
    for path in store.folder.glob(f"re/*{ASKED}.json"):
        own = path.name.removesuffix(".json")
        asked = store.result(own, NEEDS) or {"is_finished": False}
        if not asked["is_finished"]:
            name = own.removeprefix("recipe-").removesuffix(f"-{ASKED}").replace(".", "/")
            raise Failure(f"{name} was not finished, and what it needs would go: run it first")
        found.update(asked["asked"])
    return found


def is_of_command(path, own, store):
    """Not digests of modules, nor seconds of points."""
    return path.suffix != ".json" or "command" in (store.result(own, dict) or {})


def clean_unneeded():
    if not STORE.is_dir():
        say("Nothing was deleted.")
        return
    store = Store(STORE)
    ids, deleted, size = needed(store), 0, 0
    for path in store.folder.glob("[0-9a-f][0-9a-f]/*"):
        own = path.name.partition(".")[0]
        if own not in ids and is_of_command(path, own, store):
            deleted, size = deleted + 1, size + path.stat().st_size
            path.unlink()
    store.close()
    say(f"Deleted {plural(deleted, 'file')} of results that no figure needs, {size / 1e6:.1f} MB.")
