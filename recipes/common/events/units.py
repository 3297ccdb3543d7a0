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
from events.continuations import BRANCHES, OWN_BLOCK, SLIP_AT
from events.conventions import CONVENTIONS, DECAYING, IN_WORDS, PRIMARY
from events.event_claims import EVENT_CLAIMS, case_S2
from events.front_claims import words_and_order_case
from events.fronts import has_slow_stretch, is_measured, takes_time

FIRST_BRANCH, *LATER_BRANCHES = BRANCHES
FIRST_BLOCK, *OTHER_BLOCKS = SLIP_AT
NO_S2 = case_S2(None, None)


def of_ensemble(data, setting, kind):
    """Paths of what there is of the loads of a kind."""
    seed = "01" if setting == "simplified" else "[0-9][0-9][0-9]"  # simplified: one state
    return sorted((data / "ensemble").glob(f"{setting}-{seed}-{kind}.json"))


def name_of(path):
    """load-203 of .../load-203-events.json"""
    return Path(path).name.rsplit("-", 1)[0]


def of_loads(paths, case, conventions=None):
    """The cases of each event. `conventions`: {name: name in the file}; None: all of them."""
    units = {}
    for path in paths:
        events = report(path)
        names = conventions or {name: name for name in events if name in CONVENTIONS}
        units[name_of(path)] = {
            name: [case(event) for event in events[of]] for name, of in names.items()
        }
    return units


def in_words(paths):
    """Claims 2Aw, S6Aw, Expe and Expw."""
    return of_loads(paths, words_and_order_case, {PRIMARY: IN_WORDS})


def below_c_s_over_8(paths, case):
    """Claim S6A, for which slow may be up to c_s/8."""
    return of_loads(paths, case, {PRIMARY: DECAYING, "slow below c_s/20": PRIMARY})


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
    block: str = FIRST_BLOCK

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

    def fronts(self, run):
        return self.front("unmodified"), self.front(run)

    def around_transition(self):
        return self.event["unmodified"], self.event[IN_WORDS], self.of_branch("no-slow-slip")

    def widened(self):
        return *self.fronts("wider"), *(self.of_branch("phi", n) for n in ("before", "after"))

    def undriven(self):
        return tuple(self.event[name] for name in ("unmodified", "undriven", "undriven_from"))


# Conventions beside the primary one: fields of a View.
AT_BRANCHES = {f"branch at {branch} L": {"branch": branch} for branch in LATER_BRANCHES}
OF_FRONTS = {name: {"way": name} for name in CONVENTIONS if name != PRIMARY} | AT_BRANCHES
OF_SLIP = AT_BRANCHES | {f"block at {block} L": {"block": block} for block in OTHER_BLOCKS}

OF_EVENT: dict[str, tuple] = {  # conventions, what the case is made of
    "3A": (OF_FRONTS, lambda view: view.fronts("stopped")),
    "3B": (OF_FRONTS, lambda view: view.fronts("no-slow-slip")),
    "3C": (OF_SLIP, lambda view: [view.of_branch("slip", view.block)]),
    "3Cv": (OF_SLIP, lambda view: [view.of_branch("slip", view.block)]),
    "4AB": (OF_FRONTS, View.widened),
    "3Aw": (AT_BRANCHES, lambda view: [view.of_branch(IN_WORDS, "stopped")]),
    "3Bw": (AT_BRANCHES, lambda view: view.around_transition()),
    "3Cw": (AT_BRANCHES, lambda view: [view.of_branch("slip", OWN_BLOCK)]),
    "5A": ({}, View.undriven),
    "5Aw": ({}, lambda view: (view.event[IN_WORDS], *view.undriven())),
}
SLOW_AS_JUDGED = {  # of claims made of an original first: whether that can be compared with
    "3A": is_measured,
    "3B": is_measured,
    "4AB": has_slow_stretch,
    "5A": takes_time,
    "5Aw": takes_time,
}


def of_event(claim_id, event):
    """By convention; an event is a unit only if its original is slow as the claim judges it."""
    (conventions, made_of), (case, *_) = OF_EVENT[claim_id], EVENT_CLAIMS[claim_id]
    found = {}
    for name, fields in ({PRIMARY: {}} | conventions).items():
        if "way" in fields and name not in (event["conventions"] or {}):
            continue
        parts = made_of(View(event, **fields))
        if claim_id not in SLOW_AS_JUDGED or SLOW_AS_JUDGED[claim_id](parts[0]):
            found[name] = [] if None in parts else [case(*parts)]
    return found


def of_events(paths, claim_id):
    """Of every fast-slow-fast event of the loads."""
    return {
        f"{name_of(path)}, event {number}": of_event(claim_id, event)
        for path in paths
        for number, event in report(path).items()
    }
