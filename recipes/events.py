"""Independent runs of the slider, their events, and what becomes of an event when something changes
in it. Figures show one run, and events I, II and III of it from checkpoints/."""

import re
from functools import cache

from rupture.errors import Failure
from rupture.once import measured
from rupture.programs import output_of

from claims.recipes import RECIPES

CHECKPOINTS = RECIPES.parent / "checkpoints"
EVENTS = {"event I": "fast-slow-fast", "event II": "second-slow", "event III": "fast-only"}


# --- the events that figures show --------------------------------------------------------------


def checked(checkpoint, manifest):
    """Raises Failure if it is not the one in the manifest."""
    name, text = checkpoint.name, manifest.read_text(encoding="utf-8")
    if output_of("analyze", "checksum", checkpoint).strip() not in re.findall(rf"(\S+)  {name}\n", text):
        raise Failure(f"checkpoints/{name} is not in {manifest} (see README.md there)")
    return {}


@cache
def shipped(name):
    """The path of a checkpoint from which figures start."""
    path = CHECKPOINTS / f"{name}.h5"
    measured(checked, path, CHECKPOINTS / "manifest")
    return path
