"""The units of the ensemble and their cases, for the judge: {unit: {convention: [case, ...]}}.

`paths` are results/data/ensemble/SETTING-SEED-events.json, {convention: events}, or
...-continued.json, {number: what became of the event} (ensemble/continue_events.py and
without_slow_slip.py); those that there are. A unit that lacks what is asked for has no case, which
counts against the claim.
"""

from functools import partial
from pathlib import Path

from claims.judge import holds
from data.records import report
from events.continuations import BRANCHES, OWN_BLOCK, SLIP_AT
from events.conventions import CONVENTIONS, DECAYING, IN_WORDS, PRIMARY
from events.event_claims import (
    case_3A,
    case_3B,
    case_3C,
    case_3Cv,
    case_4AB,
    case_3Bw,
    case_5A,
    case_5Aw,
    case_S2,
    words_case,
)
from events.fronts import has_slow_stretch

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


# --- loads ---------------------------------------------------------------------------------


def of_loads(paths, case, conventions=None):
    """Of each event. `conventions`: {name: name in the file}; None: all of them."""
    units = {}
    for path in paths:
        events = report(path)
        names = conventions or {name: name for name in events if name in CONVENTIONS}
        units[name_of(path)] = {
            name: [case(event) for event in events[of]] for name, of in names.items()
        }
    return units


def in_words(paths):
    """Claims 2Aw, S6Aw and Expw."""
    return of_loads(paths, words_case, {PRIMARY: IN_WORDS})


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


# --- events of loads -----------------------------------------------------------------------


def cases(case, *measured):
    """The case of these fronts or slips; none if one of them is missing."""
    return [] if None in measured else [case(*measured)]


def of_branch(event, branch, run):
    return (event["branches"][branch] or {}).get(run)


def of_fronts(event, run, case_at):
    """Under each way to measure a front at the first branch, and at the later ones; `case_at` is
    given the branch. An event whose unmodified front is not slow in one way is no unit there."""
    conventions = event["conventions"] or {}
    measured = {
        name: (FIRST_BRANCH, fronts["unmodified"], fronts[run])
        for name, fronts in conventions.items()
        if name in CONVENTIONS
    }
    measured[PRIMARY] = FIRST_BRANCH, event["unmodified"], of_branch(event, FIRST_BRANCH, run)
    for branch in LATER_BRANCHES:
        measured[f"branch at {branch} L"] = (
            branch,
            event["unmodified"],
            of_branch(event, branch, run),
        )
    return {
        name: cases(case_at(branch), *fronts)
        for name, (branch, *fronts) in measured.items()
        if has_slow_stretch(fronts[0])
    }


def at_branches(case):
    """{convention: cases} of what case() says at each branch; None where it has nothing."""
    names = {FIRST_BRANCH: PRIMARY} | {b: f"branch at {b} L" for b in LATER_BRANCHES}
    found = {name: case(branch) for branch, name in names.items()}
    return {name: [] if measured is None else [measured] for name, measured in found.items()}


def words_3A(event):
    def case(branch):
        front = (of_branch(event, branch, "in words") or {}).get("stopped")
        return front and words_case(front)

    return at_branches(case)


def words_3B(event):
    def case(branch):
        front = of_branch(event, branch, "no-slow-slip")
        return front and case_3Bw(event["in words"], front)

    return at_branches(case)


def own_block_3C(event):
    def case(branch):
        slips = (of_branch(event, branch, "slip") or {}).get(OWN_BLOCK)
        return slips and case_3C(slips)

    return at_branches(case)


def undriven(event, case, original):
    """Where the original is slow."""
    runs = event["unmodified"], event["undriven"], event["undriven_from"]
    return {PRIMARY: cases(case, *runs)} if has_slow_stretch(original) else {}


def slips_3C(event, case):
    """Of claims 3C and 3Cv, at each branch and of each block."""

    def slips(branch, block):
        return cases(case, (of_branch(event, branch, "slip") or {}).get(block))

    return {
        PRIMARY: slips(FIRST_BRANCH, FIRST_BLOCK),
        **{f"branch at {branch} L": slips(branch, FIRST_BLOCK) for branch in LATER_BRANCHES},
        **{f"block at {block} L": slips(FIRST_BRANCH, block) for block in OTHER_BLOCKS},
    }


def wider_4AB(event):
    def with_phi(branch):
        phi = of_branch(event, branch, "phi") or {"before": None, "after": None}
        return lambda one, wider: case_4AB(one, wider, phi["before"], phi["after"])

    return of_fronts(event, "wider", with_phi)


OF_EVENT = {
    "3A": lambda event: of_fronts(event, "stopped", lambda _: case_3A),
    "3B": lambda event: of_fronts(event, "no-slow-slip", lambda _: case_3B),
    "3C": lambda event: slips_3C(event, case_3C),
    "3Cv": lambda event: slips_3C(event, case_3Cv),
    "4AB": wider_4AB,
    "3Aw": words_3A,
    "3Bw": words_3B,
    "3Cw": own_block_3C,
    "5A": lambda event: undriven(event, case_5A, event["unmodified"]),
    "5Aw": lambda event: undriven(event, partial(case_5Aw, event["in words"]), event["in words"]),
}


def of_events(paths, claim_id):
    """Of every fast-slow-fast event of the loads."""
    return {
        f"{name_of(path)}, event {number}": OF_EVENT[claim_id](event)
        for path in paths
        for number, event in report(path).items()
    }
