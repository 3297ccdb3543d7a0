#!/usr/bin/env python3
"""Joins the claims of a figure's parts: merge_claims.py PART.json... results/figN/claims.json"""

import sys

from claims.claim import read_claims, write_claims

if __name__ == "__main__":
    *parts, whole = sys.argv[1:]
    write_claims(whole, [claim for part in parts for claim in read_claims(part)])
