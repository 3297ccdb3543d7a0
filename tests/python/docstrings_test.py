"""The examples in the docstrings of the package give what they say."""

import doctest

import pytest

import rupture.files
import rupture.programs
from conftest import need_modules


@pytest.mark.parametrize("module", [rupture.files, rupture.programs])
def test_the_examples_of(module, small):
    need_modules("pandas", "xarray")
    names = {"rupture": rupture, "checkpoint": rupture.open("small.h5")}
    names["record"] = rupture.open("small-record.h5")
    found = doctest.testmod(module, extraglobs=names, optionflags=doctest.ELLIPSIS)
    assert found.attempted and not found.failed
