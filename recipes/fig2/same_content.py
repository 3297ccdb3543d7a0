"""Fails if two checkpoints differ in their contents: same_content.py FILE SHIPPED"""

import sys

from rupture.programs import output_of


def main(*paths):
    sums = [output_of("analyze", "checksum", path).strip() for path in paths]
    if sums[0] != sums[1]:
        sys.exit(f"the content of {paths[1]} is not what a load gives now: {sums[0]}")
    return {"sha256": sums[0]}
