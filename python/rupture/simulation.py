"""The model itself: a slider in memory, moved from Python (docs/python.md)."""

import importlib.machinery
import importlib.util
import json
import operator
import os
import sys
from functools import cache

from rupture.errors import Failure, NoSuchName, UsageError
from rupture.programs import folders, settings_of

MODULE = "rupture_simulation"
LAST_STEP = 2**53
DERIVED = ("p", "tau", "pinned")


@cache
def module():
    """The compiled module, beside the programs."""
    for folder in folders():
        for suffix in importlib.machinery.EXTENSION_SUFFIXES:
            if os.path.isfile(path := folder / f"{MODULE}{suffix}"):
                spec = importlib.util.spec_from_file_location(MODULE, path)
                assert spec and spec.loader
                try:
                    spec.loader.exec_module(found := importlib.util.module_from_spec(spec))
                except ImportError as error:
                    raise Failure(f"{path} cannot be loaded: {error}; build it again") from None
                return found
    this = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    raise Failure(
        f"rupture.Simulation is not built for {this}: install pybind11-dev and python3-dev for it, "
        "then run cmake and build rupture again"
    )


def settings(parameters):
    """Pairs of a name and a text."""
    return [word.split("=", 1) for word in settings_of(parameters) if word != "--set"]


def value_of(text):
    """A number or a word; a list of those of each block from COUNTxVALUE,COUNTxVALUE,..."""
    if "," in text:
        parts = (part.rpartition("x") for part in text.split(","))
        return [value_of(value) for count, _, value in parts for _ in range(int(count or 1))]
    try:
        return json.loads(text)
    except ValueError:
        return text


def whole(value, name, least, most=LAST_STEP):
    """A whole number within these bounds."""
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if least <= number <= most:
        return number
    raise UsageError(f"{name} must be a whole number from {least} to {most} (got {value!r})")


def thread_count(threads):
    return None if threads is None else whole(threads, "threads", 1, 1024)


def name_of(file):
    """Of a path, or of an opened file."""
    return os.fsencode(getattr(file, "path", file))


class Simulation:
    """A slider that goes on from a checkpoint: a path, or an opened one. Results do not depend on
    the number of threads. `sim[name]` is an array:

    "u_x", "u_z", "v_x", "v_z", "f_x", "f_z"       state of the blocks, [Nz][Nx] [m, m/s, N]
    "junctions/attachment", "junctions/draws", ...  state of the junctions, [Nx][S]
    "p", "tau"                                      forces on interface blocks, [Nx] [N], read-only
    "pinned"                                        pinned junctions of each, [Nx], a copy
    """

    def __init__(self, checkpoint, *, threads=None):
        self.model = module().opened(name_of(checkpoint), thread_count(threads))

    @classmethod
    def from_parameters(cls, parameters=(), *, threads=None):
        """The slider under its normal load, as `load` makes it; by default that of the paper."""
        self = cls.__new__(cls)
        self.model = module().loaded(settings(parameters), thread_count(threads))
        return self

    def __repr__(self):
        return f"<rupture.Simulation at {self.time:.9g} s>"

    @property
    def steps_done(self):
        """Time steps since the slider was made."""
        return self.model.steps_done()

    @property
    def time(self):
        """[s]"""
        return self.model.time()

    @property
    def F_T(self):
        """Driving force [N]."""
        return self.model.F_T()

    @property
    def parameters(self):
        """A dict of all parameters, as that of a file."""
        return {name: value_of(text) for name, text in self.model.parameters()}

    def __getitem__(self, name):
        if name in DERIVED:
            return self.model.derived()[name]
        if name in (state := self.model.views()):
            return state[name]
        raise NoSuchName(f"the simulation has no {name}; it has {', '.join([*state, *DERIVED])}")

    @property
    def pinned_fraction(self):
        """Fraction of each interface block's junctions that are pinned, [Nx]."""
        return self["pinned"] / self.model.springs()

    def step(self, steps=1):
        """Moves the slider by so many time steps. Other threads of Python run meanwhile. Ctrl-C
        ends it between two steps, with a KeyboardInterrupt."""
        self.model.step(whole(steps, "steps", 0))

    def run(self, until, *, call=None, every=1000):
        """Runs until a time [s], until a condition as that of `--until` holds, such as "F_T < 300",
        or until a function of this simulation is true. After every `every` steps and at the end,
        `call(sim)` is called, then `until` is looked at. What functions raise comes out as it is.
        """
        every, last = whole(every, "every", 1), LAST_STEP
        if not isinstance(until, str) and not callable(until):
            last = self.step_at(until)
        elif self.is_over(until):
            raise UsageError(f"until is true already, at {self.time:.9g} s: nothing would run")
        while (now := self.steps_done) < last:
            self.step(min(every, last - now))
            if call:
                call(self)
            if last == LAST_STEP and self.is_over(until):
                break

    def is_over(self, until):
        return self.model.what_holds(until) if isinstance(until, str) else until(self)

    def step_at(self, time):
        """The step nearest to a time [s], which must not be over."""
        try:
            step = self.model.step_at(float(time))
        except (TypeError, ValueError):
            wanted = "a time in s, a condition or a function"
            raise UsageError(f"until must be {wanted} (got {time!r})") from None
        if step < self.steps_done:
            raise UsageError(f"until {time:g} is before the simulation's time {self.time:.7g} s")
        return step

    def set(self, parameters=(), **more):
        """Changes parameters from now on, as `restart --set` does: `sim.set({"driving.V": 0})`.
        Arrays that were taken before are those of the slider as it was: take them again."""
        self.model.set(settings(parameters) + settings(more))

    def save(self, path, *, force=False):
        """Writes a checkpoint and returns its content checksum. `force` replaces a file."""
        return self.model.save(name_of(path), bool(force), sys.orig_argv)
