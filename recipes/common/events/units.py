"""The units of the ensemble and their cases, for the judge: {unit: {convention: [case, ...]}}.

`paths` are results/data/ensemble/SETTING-SEED-events.json, {convention: events}, or
...-continued.json, {number: what became of the event} (ensemble/continue_events.py and
without_slow_slip.py); those that there are. A unit that lacks what is asked for has no case, which
counts against the claim.
"""

from dataclasses import dataclass
from pathlib import Path

from claims.judge import holds
from data.records import report
from events.continuations import BRANCHES, OWN_BLOCK
from events.conventions import CONVENTIONS, PRIMARY
from events.event_claims import EVENT_CLAIMS, case_S2
from events.front_claims import words_and_order_case
from events.fronts import has_slow_stretch

FIRST_BRANCH, *LATER_BRANCHES = BRANCHES
NO_S2 = case_S2(None, None)


def of_ensemble(data, setting, kind):
    """Paths of what there is of the loads of a kind."""
    seed = "01" if setting == "simplified" else "[0-9][0-9][0-9]"  # simplified: one state
    return sorted((data / "ensemble").glob(f"{setting}-{seed}-{kind}.json"))


def name_of(path):
    """load-203 of .../load-203-events.json"""
    return Path(path).name.rsplit("-", 1)[0]


def of_loads(paths, case, conventions=tuple(CONVENTIONS)):
    """The cases of each event."""
    return {
        name_of(path): {name: [*map(case, events[name])] for name in conventions}
        for path, events in ((path, report(path)) for path in paths)
    }


def in_words(paths):
    """Claims 2A, S6A and exponential-event."""
    return of_loads(paths, words_and_order_case, [PRIMARY])


def without_slow_slip(path):
    """Claim S2, under each convention: of the fast-slow events of the load with the simplified law
    the first for which it holds, or the first. Where nothing ruptures without slow slip, there is
    nothing to compare."""
    found = {}
    for convention in CONVENTIONS:
        pairs = [event[convention] for event in report(path).values()]
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


def of_events(paths, claim_id):
    """Of every fast-slow-fast event of the loads."""
    return {
        f"{name_of(path)}, event {number}": of_event(claim_id, event)
        for path in paths
        for number, event in report(path).items()
    }
