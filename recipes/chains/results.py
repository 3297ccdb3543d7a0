"""What figure.py gets of the chains that it reads: lists of points."""

import json
from functools import cache, cached_property
from pathlib import Path

from chains.expressions import Expression, as_number
from chains.store import result_of
from chains.values import is_expression
from rupture.errors import Failure

read_result = cache(result_of)  # many points come from the same


class Result:
    """`point["tau-bar"]` is a value (a number if it is one), `point["front"]` what a command has
    reported (None if the command was left out); each of this point, or of those that it comes
    from. Raises Failure, with the sentence of the program, for a report of a point that failed."""

    def __init__(self, chain, lineage):
        self.chain, self.lineage = chain, lineage

    @cached_property
    def results(self):
        return [read_result(one["path"]) for one in self.lineage]

    @property
    def status(self):
        """`done` or `failed`."""
        return self.results[0]["status"]

    @property
    def sentence(self):
        """Why it failed."""
        return self.results[0]["sentence"]

    @property
    def values(self):
        """Its own, by name."""
        return {name: self[name] for name in self.lineage[0]["values"]}

    @property
    def base(self):
        """The file from which its commands start; None without one."""
        return self.lineage[0]["base"]

    def file(self, name):
        """The path of a file that this point keeps, or one that it comes from."""
        for one in self.lineage:
            if (path := Path(one["path"]).with_suffix(f".{name}")).exists():
                return path
        raise Failure(f"{self.chain}: no {name} is kept")

    @cached_property
    def names(self):
        """What one may ask for."""
        kinds = ("values", "elements", "commands")
        return {name: None for one in self.lineage for kind in kinds for name in one[kind]}

    def value(self, text):
        if not is_expression(text):
            return as_number(text)
        return Expression(text[1:-1], self.names).value(self.__getitem__)

    def __getitem__(self, name):
        for one, result in zip(self.lineage, self.results):
            if name in one["values"]:
                return self.value(one["values"][name])
            if name in one["elements"]:
                return one["elements"][name]
            if name in one["commands"]:
                if result["status"] != "done":
                    raise Failure(f"{self.chain}: a point failed: {result['sentence']}")
                return result["reports"].get(name)
        raise KeyError(name)


def read_chains(recipe):
    """{chain: its points} for figure.py."""
    text = Path(f"results/data/{recipe}/figure.json").read_text(encoding="utf-8")
    chains = json.loads(text)
    return {name: [Result(name, row) for row in rows] for name, rows in chains.items()}


def origin_lines(command, results):
    """For the metadata of pictures: what draws them, and the files behind these results, which are
    given as (path, result)."""
    sums = ((Path(path).stem, one.get("checksums", {})) for path, one in results)
    files = ((point, *item) for point, found in sums for item in found.items())
    return [command, *(f"{point}.{name}: content-sha256 {sum[:16]}" for point, name, sum in files)]


def read_points(path):
    """The points in a file that a chain gives to a script with {all CHAIN}."""
    root = Path(path).parents[3]
    rows = json.loads(Path(path).read_text(encoding="utf-8"))
    for one in (one for row in rows for one in row):
        one["path"] = str(root / one["path"])
    return [Result("", row) for row in rows]
