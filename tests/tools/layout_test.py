"""The layout of files stands in one table, which `rupture --describe` prints: docs/schema.md, the
Python package and the checksum of the tests say the same, and files are so."""

import re

import h5py
import pytest

from checksum import DEFAULTS, LATER, OF_LAWS, USED
from commands import json_of, output_of
from conftest import ROOT, SMALL
from rupture.layout import rows_of

DATASETS = json_of("rupture --describe")["datasets"]
BOTH = [row for rows in DATASETS.values() for row in rows]
CELLS = re.compile(r"^\| (`/.+?) \| (.+?) \| (.+?) \| (.+?) \|", re.M)


def form(row):
    """As python/rupture/layout.py writes type and lengths."""
    kind, lengths = row["type"], row["lengths"]
    if lengths.startswith("|"):
        return f"{kind}|{kind.replace('text', 'int64')}{lengths[1:]}"
    return kind + lengths


@pytest.mark.parametrize("kind", DATASETS)
def test_of_the_python_package(kind):
    table = {path: of_path for path, (of_path, _) in rows_of(kind)}
    rows = [*DATASETS[kind], *(row for row in BOTH if row["path"].startswith("/run/"))]
    assert table == {row["path"]: form(row) for row in rows}


def each(cell, names):
    values = cell.split(", ")
    return values if len(values) > 1 else values * len(names)


@pytest.mark.parametrize("kind", DATASETS)
def test_of_the_documentation(kind):
    text = (ROOT / "docs/schema.md").read_text()
    (chapter,) = re.findall(rf"\n### {kind}\n(.+?)\n###? ", text, re.I | re.S)
    said = {}
    for names, *cells in CELLS.findall(chapter):
        names = re.findall("`(.+?)`", names)
        for name, of_type, lengths, unit in zip(names, *(each(cell, names) for cell in cells)):
            said[name] = (of_type, lengths.replace("scalar", ""), unit)
    own = [row for row in DATASETS[kind] if not re.match("/(parameters|provenance)/", row["path"])]
    assert said == {row["path"]: (row["type"], row["lengths"], row["unit"]) for row in own}


def test_of_the_checksum_of_the_tests():
    table = {row["name"]: row for row in json_of("parameters --json")["parameters"]}
    laws = {law.decode() for law in USED}
    some = {name for name, row in table.items() if set(row["laws"]) != laws}
    assert OF_LAWS == {name.removeprefix("junctions.") for name in some}
    for name in some:
        used = {law.decode() for law in USED if name.removeprefix("junctions.") in USED[law]}
        assert used == set(table[name]["laws"])
    for name, value in (DEFAULTS | LATER).items():
        name = name.removeprefix("/parameters/").replace("/", ".")
        default = table[name if "." in name else f"junctions.{name}"]["default"]
        assert default == (value.decode() if isinstance(value, bytes) else value)


@pytest.mark.parametrize("law", ["simplified", "distance"])
def test_of_files(folder, law):
    output_of(
        f"load --config {SMALL} --set junctions.law={law} -o start.h5 --until 1e-4 --quiet"
        " --record record.h5 --record-every 1e-5 --crossings 0.5 --fields 1e-5"
    )
    output_of("restart start.h5 -o checkpoint.h5 --set numerics.dt=1e-7 --for 1e-5 --quiet")
    for kind, rows in DATASETS.items():
        known = {row["path"]: row for row in rows}
        with h5py.File(f"{kind}.h5", "r") as file:
            items: list = []
            file.visititems(lambda _, item: items.append(item))
            for item in (item for item in items if isinstance(item, h5py.Dataset)):
                row = known[re.sub("(?<=/provenance/)[0-9]+", "*", item.name)]
                name = "text" if item.dtype.kind == "S" else item.dtype.name
                dimensions = 0 if "|" in row["lengths"] else row["lengths"].count("[")
                found = (name, item.ndim, item.attrs["unit"].decode())
                assert found == (row["type"], dimensions, row["unit"])
