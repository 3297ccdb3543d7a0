"""What a point of a sweep needs of the computer: time, memory and threads, in [sweep] of its file."""

import math
import re
from dataclasses import dataclass

MINUTES = {"s": 1 / 60, "min": 1, "h": 60}
MEGABYTES = {"MB": 1, "GB": 1000}


@dataclass(frozen=True)
class Needs:
    minutes: int = 10
    megabytes: int = 1000
    threads: int = 1


def amount(key, text, units, example):
    """A positive quantity in the smallest whole number of what `units` has as 1."""
    match = re.fullmatch(r"([0-9.]+)\s*([A-Za-z]+)", text)
    try:
        number = math.ceil(float(match[1]) * units[match[2]])
    except (TypeError, KeyError, ValueError):
        number = 0
    if number < 1:
        raise ValueError(
            f"'{key} = {text}' is not understood: give a number and {' or '.join(units)},"
            f" as in {key} = {example}"
        )
    return number


def needs_of(section):
    """Those that a section [sweep] states, else the usual ones. Raises ValueError."""
    stated = {}
    if "time" in section:
        stated["minutes"] = amount("time", section["time"], MINUTES, "10 min")
    if "memory" in section:
        stated["megabytes"] = amount("memory", section["memory"], MEGABYTES, "2 GB")
    if "threads" in section:
        if not re.fullmatch("[1-9][0-9]{0,3}", section["threads"]):
            raise ValueError(
                f"'threads = {section['threads']}' is not understood: give a whole number from 1"
            )
        stated["threads"] = int(section["threads"])
    return Needs(**stated)
