"""One value of a JSON file, for use in a command: {VALUE} choice.json fast-slow-fast.until

Several names stand for the first of them that has a value:

    {VALUE} front.json slow.t_to t_rupture.56
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
    found = [value for value in (find(tree, name) for name in names) if value is not None]
    if not found:
        sys.exit(f"value.py: {path} has no value {' or '.join(names)}.")
    return found[0]
