"""One value of a JSON file, for use in a command: {VALUE} choice.json fast-slow-fast.until

Several names stand for the first of them that has a value; one that begins with = is a value:

    {VALUE} front.json slow.t_to t_rupture.56 =1e9
"""

import json
import sys


def find(tree, name):
    """The value that `name` leads to; None where it leads nowhere."""
    try:
        for key in name.split("."):
            tree = tree[int(key)] if isinstance(tree, list) else tree[key]
    except (KeyError, IndexError, TypeError, ValueError):
        return None
    return tree


def main(path, *names):
    with open(path, encoding="utf-8") as file:
        tree = json.load(file)
    for name in names:
        value = name[1:] if name.startswith("=") else find(tree, name)
        if value is not None:
            return value
    return sys.exit(f"value.py: {path} has no value {' or '.join(names)}.")
