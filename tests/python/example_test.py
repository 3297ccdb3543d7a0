"""The notebook docs/examples/first-front.ipynb runs: the front crosses, and arrests without
driving."""

import json
import subprocess
import sys

import rupture
from conftest import ROOT

NOTEBOOK = ROOT / "docs/examples/first-front.ipynb"


def code_of(notebook):
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


def test_the_notebook(folder):
    subprocess.run([sys.executable, "-B", "-c", code_of(NOTEBOOK)], check=True)
    assert (folder / "first-front.png").stat().st_size > 10_000
    driven, stopped = map(rupture.open, ("load-record.h5", "stopped-record.h5"))
    assert (driven.parameters["driving.V"], stopped.parameters["driving.V"]) == (4e-4, 0)
    assert any(event["spanning"] for event in rupture.analyze("events", driven)["events"])
    assert not rupture.analyze("events", stopped)["events"][0]["spanning"]
