"""Memory and threads that a point of a sweep needs, from [sweep] of its file."""

import math
import re
from dataclasses import dataclass

MEGABYTES = {"MB": 1, "GB": 1000}


@dataclass(frozen=True)
class Needs:
    megabytes: int = 1000
    threads: int = 1


def megabytes(text):
    """A positive number of them."""
    match = re.fullmatch(r"([0-9.]+)\s*([A-Za-z]+)", text)
    try:
        number = math.ceil(float(match[1]) * MEGABYTES[match[2]]) if match else 0
    except (KeyError, ValueError):
        number = 0
    if number < 1:
        raise ValueError(
            f"'memory = {text}' is not understood: give a number and {' or '.join(MEGABYTES)},"
            " as in memory = 2 GB"
        )
    return number


def needs_of(section):
    """Those that a section [sweep] states, else the usual ones. Raises ValueError."""
    stated = {}
    if "memory" in section:
        stated["megabytes"] = megabytes(section["memory"])
    if "threads" in section:
        if not re.fullmatch("[1-9][0-9]{0,3}", section["threads"]):
            raise ValueError(
                f"'threads = {section['threads']}' is not understood: give a whole number from 1"
            )
        stated["threads"] = int(section["threads"])
    return Needs(**stated)
