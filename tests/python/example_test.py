"""The notebook docs/examples/first-front.ipynb runs: the front crosses, and arrests without
driving."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import rupture

NOTEBOOK = Path(__file__).resolve().parents[2] / "docs/examples/first-front.ipynb"


def code_of(notebook):
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([sys.executable, "-B", "-c", code_of(NOTEBOOK)], check=True)
        assert Path("first-front.png").stat().st_size > 10_000
        driven, stopped = map(rupture.open, ("load-record.h5", "stopped-record.h5"))
        assert (driven.parameters["driving.V"], stopped.parameters["driving.V"]) == (4e-4, 0)
        events = rupture.analyze("events", "load-record.h5")["events"]
        assert any(event["spanning"] for event in events)
        assert not rupture.analyze("events", "stopped-record.h5")["events"][0]["spanning"]
