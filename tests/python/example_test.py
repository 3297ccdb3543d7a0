"""The notebook docs/examples/first-front.ipynb and docs/tutorial.md print what they say."""

import json
import os
import re
import shutil
import subprocess
import sys

import pytest

import rupture
from conftest import BIN, ROOT, need_simulation

need_simulation()
NOTEBOOK = ROOT / "docs/examples/first-front.ipynb"
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n|((?:^    [^\n]*\n)+)", re.MULTILINE | re.DOTALL)
LATER = ("rupture load ", "rupture map ", "rupture analyze events run-")  # as the notebook does
ONE_SEED = ("1 to 3", "1"), ("9 points: 9 done", "3 points: 3 done")


@pytest.fixture(scope="module", name="folder")
def folder_of_notebook(tmp_path_factory):
    """Where the notebook has loaded the slider, and what it printed."""
    folder = tmp_path_factory.mktemp("notebook")
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    said = subprocess.check_output([sys.executable, "-B", "-c", code], cwd=folder, text=True)
    return folder, said, cells


def said_by(words):
    done = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=False)
    assert done.returncode == (1 if "analyze diff " in words[2] else 0), words
    return done.stdout


def test_the_notebook(folder):
    where, said, cells = folder
    outputs = [one for cell in cells for one in cell.get("outputs", ())]
    assert said == "".join(line for one in outputs for line in one.get("text", ()))
    assert (where / "first-front.png").stat().st_size > 10_000
    crossed = {}
    for name in ("load", "stopped-0.42", "stopped-0.418"):
        events = rupture.analyze("events", where / f"{name}-record.h5")["events"]
        crossed[name] = [event["t_rupture"][-1] for event in events if event["spanning"]]
    [driven], [stopped], none = crossed.values()
    assert not none and stopped - driven == pytest.approx(0.010, abs=0.0005)  # as it says


def test_the_tutorial(folder, monkeypatch):
    """From the checkpoint of the notebook on, with one seed."""
    monkeypatch.chdir(folder[0])
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    shutil.copy("load-t0.400000000.h5", "run-t0.400000000.h5")
    page, said = (ROOT / "docs/tutorial.md").read_text(encoding="utf-8"), ""
    for seeds, one in ONE_SEED:
        page = page.replace(seeds, one)
    for language, code, lines in BLOCK.findall(page):
        if language == "text" and said:
            pattern = re.escape(code).replace(re.escape("...\n"), r"(?:.*\n)*?.*?\n")
            assert re.fullmatch(pattern.replace(re.escape("..."), ".*"), said), (code, said)
        elif language == "ini":
            (folder[0] / "my.ini").write_text(code, encoding="utf-8")
        else:
            commands = [line.strip() for line in lines.splitlines()]
            commands = [["sh", "-c", line] for line in commands if not line.startswith(LATER)]
            commands += [[sys.executable, "-c", code]] if language == "python" else []
            said = "".join(map(said_by, commands))
