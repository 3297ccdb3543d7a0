"""One value of a JSON file, for use in a command: {VALUE} choice.json fast-slow-fast.until"""

import json
import re
import sys


def find(tree, name):
    """The value that `name` leads to; None where it leads nowhere."""
    try:
        for key in name.split("."):
            tree = tree[int(key)] if isinstance(tree, list) else tree[key]
    except (KeyError, IndexError, TypeError, ValueError):
        return None
    return tree


def main(path, name):
    with open(path, encoding="utf-8") as file:
        value = find(json.load(file), name)
    if not re.fullmatch(r"\w[\w.+-]*", f"{value}") or value is None:  # the shell splits others
        sys.exit(f"value.py: {path} has no number or name {name}.")
    return value
