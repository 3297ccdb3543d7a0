"""Figure S4: histograms of phi before and after its modification."""

from types import SimpleNamespace

import numpy as np
from rupture.once import measured
from rupture.reports import value, values

from claims.samples import Samples
from fig4.commands import REGION, branches, change_of_means, wider
from figS4.junctions import beside_uniform
from measure.ways import PRIMARY


def shown():
    return wider("event II")


def widened():
    found = measured(beside_uniform, shown().wider_start)
    return Samples({"": SimpleNamespace(**vars(shown()), uniform=found)})


def phi(of, _):
    """S4"""
    return {
        "largest relative change of a block's mean": change_of_means(of),
        "smallest Kolmogorov-Smirnov p": of.uniform.p,
        "changed blocks": of.uniform.blocks,
        "largest distance from exact quantiles [f_thres]": of.uniform.distance,
    }


def early_branches():
    """The branches before the region in which phi changes."""
    found = branches()
    return Samples(found.shown, {PRIMARY: found.taken[PRIMARY]})


def beginning(of, way):
    """S4-begin: blocks that had ruptured when the event was changed do not count."""
    front, wider = of.fronts[way], of.wider[way]
    if wider.type is None:
        return None
    x, before, after = map(values, (front.x, front.t_rupture, wider.t_rupture))
    since = 0 if of.block is None else of.fronts[PRIMARY].t_rupture[of.block]
    apart = np.abs(after - before)[(x < REGION * front.L) & (before > since)]
    largest = apart.max() if len(apart) else np.nan
    return {
        "largest difference [ms]": largest * 1e3,
        "difference/time below c_s/10": largest / value(front, "in_words.duration"),
    }
