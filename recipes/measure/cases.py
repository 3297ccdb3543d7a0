"""The units of the ensemble and their cases, for the judge: {unit: {convention: [case, ...]}}.

They come from the points of its chains (recipes/ensemble). A unit that lacks what is asked for has
no case, which counts against the claim.
"""

from dataclasses import dataclass

from claims.judge import holds
from measure.continuations import BRANCHES, OWN_BLOCK, SLIPS
from measure.conventions import CONVENTIONS, PRIMARY
from measure.event_claims import EVENT_CLAIMS, case_S2
from measure.front_claims import words_and_order_case
from measure.fronts import has_slow_stretch, is_fast_slow

FIRST_BRANCH, *LATER_BRANCHES = BRANCHES
NO_S2 = case_S2(None, None)
AT_BLOCK = {block: place for place, block in BRANCHES.items()}


# --- points of the chains, by load ---------------------------------------------------------


def name_of(point):
    """Of its load: `load-203`, `decaying-01`, or `damping-half-203` of another chain of loads."""
    variant = point["variant"]
    try:
        seed = point["numerics.seed"]
    except KeyError:  # of the loads that figures show
        seed = 1
    return f"{'load' if variant == 'reference' else variant}-{seed:02.0f}"


def by_way(report):
    """{way to measure: report}, the primary one first."""
    return {PRIMARY: report, **report["under"]}


def events_of(points):
    """{load: {way to measure: its events}} of points of ensemble/events or shown_events."""
    return {
        name_of(point): {way: of["events"] for way, of in by_way(point["measured"]).items()}
        for point in points
    }


def ruptured(front):
    """None where nothing ruptures."""
    return front if front and front["type"] != "none" else None


def continued_of(points):
    """{load: {number of an event: what became of it}} of points of ensemble/branches:

    "event"         as it was in the load; "unmodified": its front, continued alone
    "strength"      of each block before the event
    "peaks"         of tau/p of each block
    "branches"      {branch: {run: front, "slip": {"own": {run: slip}}, "phi": {"before", "after"}}}
    "undriven"      front if the driving stops in the middle of the slow stretch, "undriven_from"
    "conventions"   {way to measure: {run: front}} of the unmodified event and of "wider"

    A branch is None where the front does not rupture its block; a front where nothing ruptures.
    """
    found: dict[str, dict] = {}
    for point in points:
        of_load = found.setdefault(name_of(point), {})
        event = of_load.setdefault(point["event"]["number"], event_of(point))
        place = AT_BLOCK[point["block"]]
        is_there = point["t"] is not None
        event["branches"][place] = branch_of(point) if is_there else None
        if place == FIRST_BRANCH and is_there:
            event["conventions"] = {
                way: {
                    "unmodified": ruptured(front),
                    "wider": ruptured(point["front_wider"]["under"][way]),
                }
                for way, front in point["front"]["under"].items()
            }
    return found


def event_of(point):
    """What continued_of() says of it, without its branches."""
    return {
        "unmodified": ruptured(point["front"]),
        **{name: point[name] for name in ("event", "strength", "peaks")},
        "branches": {},
        "undriven": ruptured(point["front_undriven"]),
        "undriven_from": point["amid"],
        "conventions": None,
    }


def branch_of(point):
    runs = {"stopped": "stopped", "no-slow-slip": "no_slow_slip", "wider": "wider"}
    slips = dict(zip(SLIPS, ("stopped", "half", "double")))
    return {
        **{name: ruptured(point[f"front_{run}"]) for name, run in runs.items()},
        "slip": {OWN_BLOCK: {name: point[f"own_slip_{run}"] for name, run in slips.items()}},
        "phi": {"before": point["phi"], "after": point["phi_wider"]},
    }


def simplified_of(points):
    """{number: {way to measure: {"with": event, "without": front}}} of points of
    ensemble/simplified: the events of the load that are fast-slow in one of these ways. An event
    is None where it is not found; a front where nothing ruptures without slow slip."""
    found = {}
    for point in points:
        event = point["event"]
        lists = by_way(point["measured"])
        as_measured = {way: same_event(event, of["events"]) for way, of in lists.items()}
        if any(is_fast_slow(one) for one in as_measured.values() if one):
            without = by_way(point["front_without"])
            found[event["number"]] = {
                way: {"with": one, "without": ruptured(without[way])}
                for way, one in as_measured.items()
            }
    return found


def same_event(event, events):
    """Of `events`, measured in another way, the one at the same time; None if there is none."""
    beginning, end = event["t_start"], event["t_end"]
    return next((e for e in events if e["t_start"] <= end and e["t_end"] >= beginning), None)


# --- cases ---------------------------------------------------------------------------------


def of_loads(loads, case, conventions=tuple(CONVENTIONS)):
    """The cases of each event; `loads` as in events_of()."""
    return {
        load: {way: [*map(case, events[way])] for way in conventions}
        for load, events in loads.items()
    }


def in_words(loads):
    """Claims 2A, S6A and exponential-event."""
    return of_loads(loads, words_and_order_case, [PRIMARY])


def without_slow_slip(events):
    """Claim S2, under each convention: of the fast-slow events of the load with the simplified law
    the first for which it holds, or the first; `events` as in simplified_of(). Where nothing
    ruptures without slow slip, there is nothing to compare."""
    found = {}
    for convention in CONVENTIONS:
        pairs = [event[convention] for event in events.values()]
        cases_of = [case_S2(pair["with"], pair["without"]) for pair in pairs if pair["without"]]
        found[convention] = next(
            (c for c in cases_of if holds("S2", [c])), (cases_of or [NO_S2])[0]
        )
    return found


@dataclass(frozen=True)
class View:
    """An event and what became of it, under one convention."""

    event: dict
    way: str = PRIMARY  # to measure its fronts
    branch: str = FIRST_BRANCH

    def of_branch(self, *keys):
        """None where there is nothing, such as a front where nothing ruptures."""
        found = self.event["branches"][self.branch]
        for key in keys:
            found = found and found.get(key)
        return found

    def front(self, run):
        if self.way != PRIMARY:
            return self.event["conventions"][self.way][run]
        return self.event["unmodified"] if run == "unmodified" else self.of_branch(run)

    def around_transition(self):
        return self.event["event"], self.of_branch("no-slow-slip")

    def widened(self):
        """None if the unmodified front is not slow: there is nothing to compare with."""
        unmodified = self.front("unmodified")
        if not has_slow_stretch(unmodified):
            return None
        phi = (self.of_branch("phi", name) for name in ("before", "after"))
        return unmodified, self.front("wider"), *phi

    def undriven(self):
        names = ("event", "unmodified", "undriven", "undriven_from")
        return tuple(self.event[name] for name in names)


# Conventions beside the primary one: fields of a View.
AT_BRANCHES = {f"branch at {branch} L": {"branch": branch} for branch in LATER_BRANCHES}
OF_FRONTS = {name: {"way": name} for name in CONVENTIONS if name != PRIMARY} | AT_BRANCHES

OF_EVENT: dict[str, tuple] = {  # conventions, what the case is made of
    "3A": (AT_BRANCHES, lambda view: [view.of_branch("stopped")]),
    "3B": (AT_BRANCHES, View.around_transition),
    "3C": (AT_BRANCHES, lambda view: [view.of_branch("slip", OWN_BLOCK)]),
    "4AB": (OF_FRONTS, View.widened),
    "5A": ({}, View.undriven),
}


def of_event(claim_id, event):
    """By convention; an event without what it is made of is no unit."""
    (conventions, made_of), (case, *_) = OF_EVENT[claim_id], EVENT_CLAIMS[claim_id]
    found = {}
    for name, fields in ({PRIMARY: {}} | conventions).items():
        if "way" in fields and name not in (event["conventions"] or {}):
            continue
        parts = made_of(View(event, **fields))
        if parts is not None:
            found[name] = [] if None in parts else [case(*parts)]
    return found


def of_events(loads, claim_id):
    """Of every fast-slow-fast event of the loads, as in continued_of()."""
    return {
        f"{load}, event {number}": of_event(claim_id, event)
        for load, events in loads.items()
        for number, event in events.items()
    }
