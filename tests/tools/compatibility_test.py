"""Files of every schema version (tests/compatibility): intact, and continued or analysed."""

import pytest

from commands import output_of
from conftest import ROOT

SCHEMAS = sorted((ROOT / "tests/compatibility").glob("schema-*"))


@pytest.mark.parametrize("schema", SCHEMAS, ids=lambda schema: schema.name)
def test_files_are_read_as_they_were_written(folder, schema):
    output_of(f"analyze verify {schema} --manifest {schema}/manifest")
    for file in schema.glob("*.h5"):
        if file.name.endswith("record.h5"):
            output_of(f"analyze events {file}")
            output_of(f"analyze loading {file}")
        else:
            output_of(f"restart {file} -q -f --for 2e-5 -o next.h5")
            output_of("analyze verify next.h5")
            output_of(f"analyze stress {file}")
