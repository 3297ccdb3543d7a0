"""Files of schemas 3 and 2 (the latter in checkpoints/): intact, and continued or analysed."""

import os

import pytest

from commands import output_of
from conftest import ROOT

FOLDERS = ["tests/compatibility/schema-3", "checkpoints"]


@pytest.mark.parametrize("name", FOLDERS)
def test_files_are_read_as_they_were_written(folder, name):
    files = ROOT / name
    os.chdir(files)
    output_of("analyze verify manifest")
    os.chdir(folder)
    for file in files.glob("*.h5"):
        if file.name.endswith("record.h5"):
            output_of(f"analyze events {file}")
            output_of(f"analyze loading {file}")
        else:
            output_of(f"restart {file} -q -f --for 2e-5 -o next.h5")
            output_of("analyze verify next.h5")
            output_of(f"analyze stress {file}")
