"""Files as tables of pandas, which need not be installed otherwise."""

import importlib

import numpy as np

from rupture.errors import Failure


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


def to_dataframe(file):
    pandas = imported("pandas")
    where = {name: getattr(file, name) for name in file.axes}
    shape = tuple(map(len, where.values()))
    columns = {}
    for name, array in file.items():
        if "/" not in name and name not in where:
            array = np.reshape(array, np.shape(array) + (1,) * (len(shape) - np.ndim(array)))
            columns[name] = np.broadcast_to(array, shape).ravel()
    return pandas.DataFrame(columns, pandas.MultiIndex.from_product(where.values(), names=where))
