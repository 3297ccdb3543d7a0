"""Files as tables of pandas and datasets of xarray, which need not be installed otherwise."""

import importlib
import json

import numpy as np

from rupture.errors import Failure

POSITIONS = ("x", "z")  # of a group, which all have the same
# Of what has no label in its file.
QUANTITIES = {"u": "displacement of", "v": "velocity of", "f": "net force on"}
LONG_NAMES = {
    f"{q}_{a}": f"{name} the block along {a}" for q, name in QUANTITIES.items() for a in "xz"
}
LONG_NAMES |= {"time": "time", "x": "position of the block", "z": "height above the interface"}
LONG_NAMES |= {"field_time": "time of the fields", "ruptures_x": "position of the block"}


def text(attribute):
    return attribute.decode(errors="replace") if isinstance(attribute, bytes) else str(attribute)


def imported(name):
    try:
        return importlib.import_module(name)
    except ImportError:
        package = f"apt-get install python3-{name.split('.')[0]}"
        raise Failure(f"{name} is not installed; install it, on Debian with {package}") from None
    except (RuntimeError, ValueError) as error:  # of HOME, or of settings such as MPLBACKEND
        raise Failure(f"{name} refuses its settings: {error}") from None


def coordinates_of(file):
    """{name: (dimension, values)}"""
    found = {name: (name, getattr(file, name)) for name in file.dimensions[file.home]}
    if "fields/time" in file:
        found |= {"field_time": ("field_time", file["fields/time"]), "z": ("z", file.z)}
    if "ruptures/block" in file:
        found["ruptures_x"] = ("rupture", file.x[file["ruptures/block"]])
    return found


def dimensions_of(file, name, array):
    """The names of an array's dimensions, by its group; a dimension without a name gets its own."""
    path = name if "/" in name and name.split("/")[0] in file.dimensions else f"{file.home}/{name}"
    group = path.rpartition("/")[0]
    named = file.dimensions.get(group, ())[: np.ndim(array)]
    known = len(named) == np.ndim(array) and name != "crossings/levels"
    return named if known else tuple(f"{name}_{n}".replace("/", "_") for n in range(np.ndim(array)))


def labels_of(file, name):
    """Labels for the axes of plots; records have theirs in the file."""
    own, units = LONG_NAMES.get(name, name), "s" if name.endswith("time") else "m"
    if name in file:
        own, units = file.dataset(name).attrs.get("long_name", own), file.units(name)
    return {"units": units, "long_name": text(own)}


def to_xarray(file):
    xarray = imported("xarray")
    places = coordinates_of(file)
    coordinates = {name: (*place, labels_of(file, name)) for name, place in places.items()}
    variables = {}
    for name, array in file.items():
        if name.split("/")[-1] in POSITIONS or name in ("fields/time", *coordinates):
            continue
        dimensions = dimensions_of(file, name, array)
        variables[name.replace("/", "_")] = (dimensions, array, labels_of(file, name))
    attributes = {"source": str(file.path), "content_checksum": file.checksum}
    attributes["provenance"] = json.dumps(file.provenance)
    return xarray.Dataset(variables, coordinates, attributes | file.parameters)


def to_dataframe(file):
    pandas = imported("pandas")
    where = {name: getattr(file, name) for name in file.dimensions[file.home]}
    shape = tuple(map(len, where.values()))
    columns = {}
    for name, array in file.items():
        if "/" not in name and name not in where:
            array = np.reshape(array, np.shape(array) + (1,) * (len(shape) - np.ndim(array)))
            columns[name] = np.broadcast_to(array, shape).ravel()
    return pandas.DataFrame(columns, pandas.MultiIndex.from_product(where.values(), names=where))
