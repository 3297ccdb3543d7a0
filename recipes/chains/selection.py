"""Which points the chains of a plan have: products of values, rows of tables, and those that follow
from points of other chains."""

import itertools
import math
import os
from functools import cached_property
from pathlib import Path

from chains.chain import Chain
from chains.ini import existing
from chains.points import Point, Waiting, each, those
from chains.programs import Programs
from chains.values import LIMIT, calculated, products, rows_in
from rupture.errors import UsageError


class Chains:
    """All chains that a plan needs, by file, and their points."""

    def __init__(self):
        self.chains: dict[Path, Chain] = {}
        self.made: dict[Path, list] = {}

    @cached_property
    def programs(self):
        return Programs()

    @property
    def deciding(self):
        """Points whose reports were asked for: with others, there may be other points."""
        return [point for points in self.made.values() for point in points if point.decides]

    def load(self, path):
        path = existing(Path(os.path.abspath(path)))
        if path not in self.chains:
            self.chains[path] = Chain(path)
        return self.chains[path]

    def above(self, chain):
        """The chain that its points come from; None if there is none."""
        if chain.table or not chain.points["chain"]:
            return None
        with chain.errors_at("chain", "points"):
            return self.load(chain.path.parent / f"{chain.points['chain']}.ini")

    def points(self, chain):
        """Raises Waiting if others must be computed first: those in `deciding`."""
        if chain.path not in self.made:
            self.made[chain.path] = self.make(chain)
        return self.made[chain.path]

    def make(self, chain):
        with chain.errors_at("chain", "points"):
            found = [*self.all_points(chain)]
            if condition := chain.points["condition"]:
                found = those(lambda one: one.worked_out(condition, one.look_up), found)
        each(lambda one: one.id, found)  # its base may wait, too
        return found[:1] if chain.points["first"] else found

    def all_points(self, chain):
        """Every start with every combination of values; the last name varies fastest."""
        starts = list(self.starts(chain))
        rows = rows_in(chain.table) if chain.table else [{}]
        found = products(dict(chain.lists), rows)
        count = len(starts) * sum(math.prod(map(len, lists.values())) for lists in found)
        if count > LIMIT:
            raise UsageError(f"there are {count:,} points; at most {LIMIT:,} are possible")
        for of, elements in starts:
            for lists in found:
                for texts in itertools.product(*lists.values()):
                    yield Point(chain, calculated(dict(zip(lists, texts))), of, elements)

    def starts(self, chain):
        """Pairs: the point that others come from, and {name: element of a list of its report}."""
        above = self.above(chain)
        starts = self.points(above) if above else [None]
        if not chain.points["list"]:
            return [(point, {}) for point in starts]
        starts = [point for point in starts if may_start(chain, point)]
        lists = each(lambda point: point.worked_out(chain.points["list"], point.known), starts)
        name = chain.points["element"]
        if not all(listed is None or isinstance(listed, list) for listed in lists):
            raise UsageError(f"{chain.points['list']} is no list")
        return [(of, {name: one}) for of, listed in zip(starts, lists) for one in listed or ()]


def may_start(chain, point):
    """Whether the condition allows points from this one, as far as one knows without its report."""
    without = Point(chain, {}, point)
    try:
        return without.worked_out(chain.points["condition"] or "True", without.look_up)
    except (Waiting, ValueError):  # it waits, or names what is not there yet
        return True
