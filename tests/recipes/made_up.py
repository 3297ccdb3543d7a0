"""Points of chains (chains/results.py) with made-up reports."""

from rupture.errors import Failure


class Made(dict):
    """A point with these reports and values."""

    status = "done"

    @property
    def names(self):
        return self

    @property
    def results(self):
        return [{"reports": {n: r for n, r in self.items() if isinstance(r, dict)}}]

    def __getitem__(self, name):
        if self.status == "failed":
            raise Failure("a point failed")
        return super().__getitem__(name)
