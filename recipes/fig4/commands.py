"""Figure 4: events I and II with a wider phi, the strength of blocks, and a map of front types."""

from functools import cache

import numpy as np
from rupture.once import keep, run

from claims.samples import Samples
from events import EVENTS, shown_event, units_of_branches, widened
from measure.conventions import PRIMARY

REGION = 0.25  # from here on phi is changed [L]
SHOWN = ("event II", "event I")  # the paper shows the first


# --- A-B: a wider phi --------------------------------------------------------------------------


@cache
def wider(name):
    """Event I or II as it is, and with the wider phi; both from its checkpoint on."""
    of = shown_event(EVENTS[name])
    found = widened(of.start, 0.01)
    keep(found.start, found.record)
    of.wider_start, of.wider_record, of.block = found.start, found.record, None
    of.fronts = {PRIMARY: of.front}
    of.wider = {PRIMARY: run(f"analyze front {found.record} --event 0")}
    of.phi_wider = run(f"analyze phi {found.start}")
    return of


def branches():
    """Events I and II; those of the ensemble begin when the front is at the branch."""
    return Samples({name: wider(name) for name in SHOWN}, units_of_branches())


def change_of_means(of):
    """The largest relative change of a block's mean."""
    before, after = np.array(of.phi.mean), np.array(of.phi_wider.mean)
    return np.max(np.abs(after - before) / np.abs(before))


def types(of, way):
    """4AB"""
    unmodified = of.fronts[way].type
    return unmodified == "slow" and {
        "front with the wider phi": of.wider[way].type,
        "unmodified": unmodified,
        "largest relative change of a block's mean": change_of_means(of),
    }
