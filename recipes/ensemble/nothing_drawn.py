#!/usr/bin/env python3
"""Fails if a slipping time has been drawn: nothing_drawn.py checkpoint.h5"""

import sys

import rupture

if rupture.open(sys.argv[1])["junctions/draws"].any():
    sys.exit("a slipping time has been drawn: loads that differ in their seeds differ here")
