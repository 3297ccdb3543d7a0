"""Whether a seed has had an effect yet."""

import rupture
from rupture.errors import Failure


def nothing_drawn(checkpoint):
    """Raises Failure if a slipping time has been drawn."""
    if rupture.open(checkpoint)["junctions/draws"].any():
        raise Failure("a slipping time has been drawn: runs that differ in their seeds differ here")
    return {"drawn": False}
