"""Fails if a slipping time has been drawn: nothing_drawn.py checkpoint.h5"""

import sys

import rupture


def main(path):
    if rupture.open(path)["junctions/draws"].any():
        sys.exit("a slipping time has been drawn: loads that differ in their seeds differ here")
    return {"drawn": False}
