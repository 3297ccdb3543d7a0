"""Rows of claims.toml: what they measure, and when they hold, on made-up samples (examples.py)."""

import ast
import inspect

from pytest import fixture, mark
from rupture.once import Report

from claims.conditions import as_number, met
from claims.judge import found_in, function
from claims.recipes import RECIPES, paper_of, recipe_names
from claims.table import table
from examples import EXAMPLES, Instead


def copied(part):
    """As reports are read."""
    if isinstance(part, dict):
        return Report({name: copied(one) for name, one in part.items()})
    return [copied(one) for one in part] if isinstance(part, (list, tuple)) else part


def changed(sample, change):
    """The sample with {"part.entry": value}."""
    if isinstance(change, Instead):
        return copied(change.sample)
    found = copied(sample)
    for name, value in change.items():
        *path, last = name.split(".")
        place = found
        for key in path:
            place = place[int(key)] if isinstance(place, list) else place[key]
        place[int(last) if isinstance(place, list) else last] = copied(value)
    return found


def answers(measured, conditions, example):
    """Whether the claim holds for this sample, and with each change of it."""
    for change in ({}, *example.within, *example.beyond):
        [one] = found_in(measured, changed(example.sample, change))
        yield all(met(wanted, one[name]) for name, wanted in conditions.items())


def expected(example):
    return [True] * (1 + len(example.within)) + [False] * len(example.beyond)


@fixture(autouse=True)
def few_resamples(monkeypatch):
    """So many are enough where runs are of two kinds, as in the examples."""
    monkeypatch.setattr("claims.resampling.RESAMPLES", 40)


ROWS: dict = {}
for recipe in recipe_names(RECIPES.parent):
    ROWS |= table(paper_of(recipe))
JUDGED = {name: row for name, row in ROWS.items() if row["conditions"]}


def test_each_claim_with_conditions_has_an_example():
    assert EXAMPLES.keys() == JUDGED.keys()


@mark.parametrize("claim_id", EXAMPLES)
def test_a_claim_holds_within_its_bounds_and_not_beyond(claim_id):
    row, example = JUDGED[claim_id], EXAMPLES[claim_id]
    found = [*answers(function(row, "measured"), row["conditions"], example)]
    assert found == expected(example)


@mark.parametrize("claim_id", ROWS)
def test_a_row_names_functions_of_its_recipe_that_say_which_claim_they_measure(claim_id):
    row = ROWS[claim_id]
    assert not inspect.signature(function(row, "samples")).parameters
    assert len(inspect.signature(function(row, "measured")).parameters) == 2
    named = row.get("like", claim_id.rpartition("/")[2])
    assert named in function(row, "measured").__doc__


@mark.parametrize("claim_id", ROWS)
def test_what_is_measured_in_several_ways_differs_by_way(claim_id):
    of = inspect.unwrap(function(ROWS[claim_id], "measured"))
    names = [node.id for node in ast.walk(ast.parse(inspect.getsource(of))) if hasattr(node, "id")]
    assert "way" in names or not ROWS[claim_id].get("ways")


TURNED = {"at_least": "at_most", "at_most": "at_least", "above": "below", "below": "above"}


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


OTHERS: dict[type, type] = {ast.Lt: ast.GtE, ast.Gt: ast.LtE, ast.GtE: ast.Lt, ast.LtE: ast.Gt}
OTHERS |= {ast.Eq: ast.NotEq, ast.Sub: ast.Add, ast.Div: ast.Mult, ast.Mult: ast.Div}
EXTREMES = {"max": "min", "min": "max"}
ALIKE = "before.centroid() + unloaded.centroid()"  # of S1, where p is symmetric: that is at 0


def used_by(tree, quantities):
    """The parts of a function that lead to these quantities."""
    dicts = [node for node in ast.walk(tree) if isinstance(node, ast.Dict)]
    pairs = [pair for node in dicts for pair in zip(node.keys, node.values)]
    found = [v for k, v in pairs if isinstance(k, ast.Constant) and k.value in quantities]
    given = [node for node in ast.walk(tree) if isinstance(node, ast.Assign)]
    for part in found:  # grows meanwhile
        names = {node.id for node in ast.walk(part) if isinstance(node, ast.Name)}
        for node in given:
            targets = {one.id for of in node.targets for one in ast.walk(of) if hasattr(one, "id")}
            if targets & names and node.value not in found:
                found.append(node.value)
    return found


def faults_in(function, quantities):
    """The function with one operator of what leads to these quantities changed, and which."""
    text = inspect.getsource(function)
    count = len([*ast.walk(ast.parse(text))])
    for number in range(count):
        tree = ast.parse(text)
        node = [*ast.walk(tree)][number]
        parts = {one for part in used_by(tree, quantities) for one in ast.walk(part)}
        if isinstance(node, ast.Compare) and type(node.ops[0]) in OTHERS:
            node.ops[0] = OTHERS[type(node.ops[0])]()
        elif isinstance(node, ast.BinOp) and type(node.op) in OTHERS:
            node.op = OTHERS[type(node.op)]()
        elif isinstance(node, ast.Name) and node.id in EXTREMES:
            node.id = EXTREMES[node.id]
        elif isinstance(node, ast.Attribute) and node.attr in EXTREMES:
            node.attr = EXTREMES[node.attr]
        else:
            continue
        if node in parts and ast.unparse(node) != ALIKE:
            names = dict(vars(inspect.getmodule(function)))
            exec(compile(ast.fix_missing_locations(tree), "fault", "exec"), names)
            yield f"{ast.unparse(node)} in line {node.lineno}", names[function.__name__]


def is_noticed(measured, conditions, example):
    try:
        return [*answers(measured, conditions, example)] != expected(example)
    except (TypeError, ValueError, AttributeError):
        return True


@mark.parametrize("claim_id", EXAMPLES)
def test_a_fault_in_a_row_or_in_what_it_measures_changes_the_answer(claim_id):
    row, example = JUDGED[claim_id], EXAMPLES[claim_id]
    measured, conditions = function(row, "measured"), row["conditions"]
    unseen = [
        (name, other)
        for name, condition in conditions.items()
        for other in other_conditions(condition)
        if not is_noticed(measured, conditions | {name: other}, example)
    ]
    unseen += [
        fault
        for fault, of in faults_in(measured, conditions)
        if not is_noticed(of, conditions, example)
    ]
    assert unseen == []
