"""Expressions in files of chains and claims: what they are worth, and what they may not have
(recipes/chains/expressions.py)."""

import pytest

from chains.expressions import Expression

NAMES = {"x": 3, "a.b": [1, 2.5, None], "none": None, "sigma-bar": 0.2, "v": "slow", "seed": 1}
VALUES = [  # an expression, and what it is; null is None
    ("1 + 2 * x", 7),
    ("-x ** 2 / 2", -4.5),
    ("a.b[1] + a.b[0]", 3.5),
    ("a.b[-1]", None),
    ("a.b[-1] + 1", None),
    ("none.t[3]", None),
    ("none or x", 3),
    ("none and x", None),
    ("0 < x < 3", False),
    ("0 < none", None),
    ("none is None", True),
    ("none is not None or x == 3", True),
    ("not x == 2", True),
    ("sigma-bar == 0.2 and v == 'slow'", True),
    ("x - seed", 2),
    ("v in ('slow', 'fast')", True),
    ("v not in ('slow', 'fast')", False),
    ("max(x, 5)", 5),
    ("max(a.b)", None),
    ("max(known(a.b)) + min(known(a.b))", 3.5),
    ("len(known(a.b))", 2),
    ("round(2.00049, 3)", 2.0),
    ("sqrt(9) + abs(-1)", 4),
]


@pytest.mark.parametrize("text, value", VALUES)
def test_expressions(text, value):
    assert Expression(text, NAMES).value(NAMES.__getitem__) == value


REFUSED = [  # an expression, and a word of the sentence
    ("__import__('os')", "not allowed"),
    ("x.__class__.__mro__()", "not allowed"),
    ("[y for y in a for z in b]", "not allowed"),
    ("[y.z for y.z in a]", "not allowed"),
    ("(lambda: 1)()", "not allowed"),
    ("x if v else 1", "not allowed"),
    ("f'{x}'", "not allowed"),
    ("1j", "not allowed"),
    ("max(x, key=v)", "not allowed"),
    ("x +", "cannot be read"),
    ("(" * 500 + ")" * 500, "cannot be read"),
    ("1" + "+1" * 5000, "cannot be"),
    ("x.real", "cannot be worked out"),
    ("v * 1000", "arithmetic is for numbers"),
    ("x ** x ** x ** x ** x", "cannot be worked out"),
    ("x / 0", "cannot be worked out"),
    ("(0 - x) ** 0.5", "not a finite real number"),
    ("a.b[7]", "cannot be worked out"),
    ("nope", "there is no nope"),
]


@pytest.mark.parametrize("text, sentence", REFUSED)
def test_what_expressions_may_not_have(text, sentence):
    with pytest.raises(ValueError, match=sentence):
        Expression(text, NAMES).value(NAMES.__getitem__)
