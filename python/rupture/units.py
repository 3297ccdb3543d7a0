"""Numbers with units, as the programs read them. Mistakes are ValueErrors."""

import re
import unicodedata
from functools import cache

NUMBER = r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
PREFIXES = {"": 0, "G": 9, "M": 6, "k": 3, "m": -3, "u": -6, "µ": -6, "μ": -6, "n": -9}
SYMBOLS = ("m", "s", "m/s", "g", "N", "N/m", "N/m^2", "Pa")
UNIT = rf"([{''.join(PREFIXES)}]?)({'|'.join(map(re.escape, SYMBOLS))})"
AMOUNT = re.compile(rf"([-+]?{NUMBER})\s*({UNIT})?")


def one_name(text):
    """The text with composed letters and one of the two micro signs, as others of the same look."""
    return unicodedata.normalize("NFC", text).replace("\u03bc", "\u00b5")


def amount(text):
    """The number as it is written; its unit, the prefix and the symbol of that."""
    match = AMOUNT.fullmatch(text)
    is_small = match and match[4] in ("m", "s", "m/s")  # no megaseconds
    if not match or (is_small and match[3] in ("G", "M", "k")):
        raise ValueError(f"'{text}' is not a number")
    return match.groups(default="")


@cache  # many points have the same
def in_si(text):
    """The number and its unit, such as 0.01 and s of 10ms."""
    number, _, prefix, symbol = amount(text)
    unit, power = ("kg", -3) if symbol == "g" else (symbol, 0)
    mantissa, _, exponent = number.lower().partition("e")
    value = float(f"{mantissa}e{int(exponent or 0) + PREFIXES[prefix] + power}")
    if not value and re.search("[1-9]", mantissa):
        raise ValueError(f"'{text}' is not a number that can be told from 0")
    return value, unit


def unit_in(text):
    """ms of 10ms; empty if there is none."""
    match = AMOUNT.fullmatch(text)
    return match[2] or "" if match else ""


def without_unit(text):
    """10ms becomes 0.01. A text without a unit stays as it is."""
    match = AMOUNT.fullmatch(text)
    return repr(in_si(text)[0]) if match and match[2] else text
