"""Rows of claims.toml: what they measure, and when they hold, on made-up reports (examples.py)."""

import json
import re

from pytest import mark

from chains.check import check_expression, names_of
from chains.selection import Chains
from claims import judge
from claims.cases import Names, of_selection
from claims.conditions import as_number
from conftest import ROOT
from examples import EXAMPLES
from made_up import Made
from reproduce.recipes import paper_of, recipe_names
from rupture.errors import Failure


def changed(reports, change):
    """The reports with {"report.entry": value}."""
    found = json.loads(json.dumps(reports))  # a copy that shares nothing
    for name, value in change.items():
        *path, last = name.split(".")
        place = found
        for key in path:
            place = place[int(key)] if isinstance(place, list) else place.setdefault(key, {})
        place[int(last) if isinstance(place, list) else last] = value
    return Made(found)


def answers(row, example):
    """Whether the claim holds for a point with these reports, and with each change of them."""
    for change in ({}, *example.within, *example.beyond):
        case = Names(row, changed(example.reports, change)).case(row["conditions"])
        yield all(judge.met(wanted, case[name]) for name, wanted in row["conditions"].items())


def expected(example):
    return [True] * (1 + len(example.within)) + [False] * len(example.beyond)


ROWS: dict = {}
for recipe in recipe_names(ROOT):
    ROWS |= judge.table(paper_of(recipe))
JUDGED = {name: row for name, row in ROWS.items() if row["conditions"]}


def test_each_claim_with_conditions_has_an_example():
    assert EXAMPLES.keys() == JUDGED.keys()


@mark.parametrize("claim_id", EXAMPLES)
def test_a_claim_holds_within_its_bounds_and_not_beyond(claim_id):
    example = EXAMPLES[claim_id]
    assert list(answers(JUDGED[claim_id], example)) == expected(example)


def texts_of(row, key):
    """The points that a row names under a key, also in its conventions."""
    found = [of[key] for of in (row, *row.get("under", {}).values()) if key in of]
    return [text for of in found for text in (of.values() if isinstance(of, dict) else [of])]


def formulas(row, quantities):
    """{(section, name): text} of what is measured, and of what this uses."""
    found = {("measured", name): row["measured"][name] for name in quantities}
    for _ in row.get("with", ()):  # what these use, and what that uses
        used = " ".join(found.values())
        found |= {("with", n): t for n, t in row["with"].items() if re.search(rf"\b{n}\b", used)}
    return found


@mark.parametrize("claim_id", ROWS)
def test_names_in_a_row_are_those_of_chains_that_its_recipe_reads(claim_id):
    row, chains = ROWS[claim_id], Chains()
    figure = chains.recipe(row["recipe"])
    pairs = (chain for key in ("reads", "beside") for chain in chains.read_by(figure, key))
    read = {chain.name.removeprefix(f"{row['recipe']}/"): chain for chain, _ in pairs}
    for key, quantities in (("shown", row["measured"]), ("each", row["conditions"])):
        own = row.get("with", {}) | (row.get("in_picture", {}) if key == "shown" else {})
        texts = formulas(row | {"with": own}, quantities).values()
        for text in texts_of(row, key):
            where = of_selection(text)
            names = own.keys() | names_of(chains, read[where["chain"]]) | {where["element"]}
            for expression in (where["condition"] or "1", *texts):
                check_expression(expression, names - {None})


TURNED = {"at_least": "at_most", "at_most": "at_least", "above": "below", "below": "above"}
OPERATORS = {" < ": " >= ", " > ": " <= ", " >= ": " < ", " <= ": " > ", " == ": " != "}
OPERATORS |= {" and ": " or ", "max(": "min(", "min(": "max(", " - ": " + ", " / ": " * "}
OPERATORS |= {" * ": " / ", " is not ": " is ", "not ": ""}


def other_conditions(condition):
    """With one number or one comparison changed."""
    if not isinstance(condition, dict):
        yield {"yes": "no", "no": "yes"}.get(condition, 7)
        return
    for relation, bound in condition.items():
        number = as_number(bound)
        near = (number - 1, number + 1) if bound in range(10) else (0.7 * number, 1.4 * number)
        yield from (condition | {relation: moved} for moved in near)
        if TURNED[relation] not in condition:
            yield {TURNED[r] if r == relation else r: b for r, b in condition.items()}


def faults_in(row):
    """(section, name, new value): one number or one operator of the conditions and of what these
    use is changed."""
    for name, condition in row["conditions"].items():
        yield from (("conditions", name, other) for other in other_conditions(condition))
    for (section, name), text in formulas(row, row["conditions"]).items():
        for old, new in OPERATORS.items():
            for found in re.finditer(re.escape(old), text):
                yield section, name, text[: found.start()] + new + text[found.end() :]


def is_noticed(row, example):
    try:
        return list(answers(row, example)) != expected(example)
    except (Failure, TypeError, ValueError):
        return True


@mark.parametrize("claim_id", EXAMPLES)
def test_a_fault_in_a_row_changes_the_answer_to_an_example(claim_id):
    row, unseen = JUDGED[claim_id], []
    for section, name, new in faults_in(row):
        if not is_noticed(row | {section: row[section] | {name: new}}, EXAMPLES[claim_id]):
            unseen.append((section, name, new))
    assert unseen == []
