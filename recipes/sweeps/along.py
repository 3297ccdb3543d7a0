"""What varies along x at the points of a sweep, as lines for its picture."""

import re

import numpy as np

import rupture
from rupture.units import in_si
from sweeps.values import is_along_x, rows_in
from sweeps.words import Later


def given(sweep):
    """Yields name and text of all parameters that the commands set, and of options."""
    for point in sweep.points:
        for words in (sweep.words(command, point) for command in sweep.commands):
            for word, value in zip(words, words[1:]):
                option, equals, own = word.partition("=")
                if not isinstance(word if equals else value, Later):
                    value = own if equals else value
                    yield value.partition("=")[::2] if option == "--set" else (option, value)


def in_numbers(texts, words):
    return [words.index(text) if words else in_si(f"{text}")[0] for text in texts]


def lines_along_x(sweep):
    """[(row of `rupture parameters --json`, its lines)] of each parameter that varies along x at
    some point. A line is (places, values). Parts lie over other values, those of the base or the
    default if no command sets any."""
    known, texts, found = sweep.described.parameters, dict.fromkeys(given(sweep)), []
    base = rupture.open(sweep.base).parameters if sweep.base else {}
    length = base.get("slider.L", known["slider.L"]["default"])
    tables = [rows_in(sweep.folder / path) for name, path in texts if name == "--profile"]
    for name, row in known.items():
        own = [text for other, text in texts if other == name]
        parts = [re.split(" from | to ", text) for text in own if is_along_x(text)]
        lines = [(ends, [value, value]) for value, *ends in parts]
        columns = [table for table in tables if name in table[0]]
        lines += [([at["x"] for at in table], [at[name] for at in table]) for table in columns]
        others = [text.split(",") for text in own if not is_along_x(text)]
        if not others and not columns:
            before = base.get(name, row["default"])
            others = [before if isinstance(before, list) else [before]]
        if lines or max(map(len, others)) > 1:
            whole = (values if len(values) > 1 else 2 * values for values in others)
            lines += [(np.linspace(0, length, len(values)), values) for values in whole]
            words = row.get("words")
            numbers = [(in_numbers(x, ()), in_numbers(values, words)) for x, values in lines]
            found.append((row, numbers))
    return found
