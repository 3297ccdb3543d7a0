"""Conditions as in claims.toml: whether a value meets one, and how a reader sees both."""

from fractions import Fraction
from operator import ge, gt, le, lt

from claims.claim import number

RELATIONS = {"at_least": ge, "at_most": le, "above": gt, "below": lt}


def as_number(bound):
    """Reads a bound that is written as 0.5 or "1/200"."""
    return float(Fraction(str(bound)))


def met(condition, value):
    """A quantity that could not be measured (None) meets no condition."""
    if value is None or not isinstance(condition, dict):
        return value is not None and str(value) == str(condition)
    return all(RELATIONS[name](value, as_number(bound)) for name, bound in condition.items())


def as_read(name, value):
    """0.005 of "slowest/c_s" is c_s/200; a bound is a text as in the table."""
    if name.endswith("/c_s") and isinstance(value, (int, float)) and value > 0:
        return f"c_s/{1 / value:.3g}" if value < 1 else f"{value:.3g} c_s"
    return number(value)


def wanted(name, condition):
    """0.5 to 3; at least 10"""
    if not isinstance(condition, dict):
        return str(condition)
    c_s = name.endswith("/c_s")
    bounds = {n: as_read(name, as_number(b)) if c_s else str(b) for n, b in condition.items()}
    if bounds.keys() == {"at_least", "at_most"}:
        return f"{bounds['at_least']} to {bounds['at_most']}"
    return " and ".join(f"{name.replace('_', ' ')} {bound}" for name, bound in bounds.items())
