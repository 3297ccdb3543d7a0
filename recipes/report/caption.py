# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Numbers in captions come from the results: "at {2A: fast before [m/s]}" in a recipe's README
becomes "at 229.1 m/s", from the claims and the own results that the recipe has written."""

import re

from claims.claim import number, split_unit

NOT_RUN = "not run"
PLACE = re.compile(r"\{(\w+):\s([^{}]+)\}")  # {claim: quantity [unit]}


def value_text(claims, claim_id, name):
    """With its unit; NOT_RUN where the claim or the quantity is missing."""
    measured = next((claim.measured for claim in claims if claim.id == claim_id), None)
    if not isinstance(measured, dict) or name not in measured:
        return NOT_RUN
    value, unit = measured[name], split_unit(name)[1]
    return number(value) if value is None else f"{number(value)} {unit}".rstrip()


def filled(text, claims):
    """A place may go over the end of a line."""
    return PLACE.sub(lambda place: value_text(claims, place[1], " ".join(place[2].split())), text)
