"""./reproduce.sh clean --unneeded: deletes results that no recipe has asked for last time."""

from reproduce.project import STORE, say
from reproduce.stamps import ASKED, NEEDS
from rupture.commands.store import Store
from rupture.errors import Failure
from rupture.tools.command_line import plural


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
