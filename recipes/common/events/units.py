"""The units of the ensemble and their cases, for the judge: {unit: {convention: [case, ...]}}.

`paths` are results/data/ensemble/SETTING-SEED-events.json, {convention: events}, or
...-continued.json, {number: what became of the event} (ensemble/continue_events.py and
without_slow_slip.py); those that there are. A unit that lacks what is asked for has no case, which
counts against the claim.
"""

from pathlib import Path

from data.records import report
from events.continuations import BRANCHES, SLIP_AT
from events.conventions import CONVENTIONS, DECAYING, IN_WORDS, PRIMARY
from events.event_claims import (
    case_3A,
    case_3B,
    case_3C,
    case_3Cv,
    case_4AB,
    case_5A,
    case_S2,
    words_case,
)

FIRST_BRANCH, *LATER_BRANCHES = BRANCHES
FIRST_BLOCK, *OTHER_BLOCKS = SLIP_AT


def of_ensemble(data, setting, kind):
    """Paths of what there is of the loads of a kind."""
    return sorted((data / "ensemble").glob(f"{setting}-[0-9][0-9]-{kind}.json"))


def name_of(path):
    """load-03 of .../load-03-events.json"""
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


def without_slow_slip(paths):
    """Claim S2, for the fast-slow events of each load with the simplified law."""
    return {
        name_of(path): {
            convention: [
                case_S2(event[convention]["with"], event[convention]["without"])
                for event in report(path).values()
            ]
            for convention in CONVENTIONS
        }
        for path in paths
    }


# --- events of loads -----------------------------------------------------------------------


def cases(case, *measured):
    """The case of these fronts or slips; none if one of them is missing."""
    return [] if None in measured else [case(*measured)]


def of_branch(event, branch, run):
    return (event["branches"][branch] or {}).get(run)


def of_fronts(event, run, case_at):
    """Under each way to measure a front at the first branch, and at the later ones; `case_at` is
    given the branch."""
    case, unmodified = case_at(FIRST_BRANCH), event["unmodified"]
    units = {PRIMARY: cases(case, unmodified, of_branch(event, FIRST_BRANCH, run))}
    for name, fronts in (event["conventions"] or {}).items():
        if name in CONVENTIONS and name != PRIMARY:
            units[name] = cases(case, fronts["unmodified"], fronts[run])
    return units | {
        f"branch at {branch} L": cases(case_at(branch), unmodified, of_branch(event, branch, run))
        for branch in LATER_BRANCHES
    }


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
    "5A": lambda event: {
        PRIMARY: cases(case_5A, event["unmodified"], event["undriven"], event["undriven_from"])
    },
}


def of_events(paths, claim_id):
    """Of every fast-slow-fast event of the loads."""
    return {
        f"{name_of(path)}, event {number}": OF_EVENT[claim_id](event)
        for path in paths
        for number, event in report(path).items()
    }
