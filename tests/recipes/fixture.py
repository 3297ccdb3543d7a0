"""A small project with made-up results, for the tests of the report."""

import io
import json
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from types import SimpleNamespace

from PIL import Image

from claims.table import table
from conftest import ROOT
from report.jobs import write_jobs
from report.page import main
from report.written import MARKER, hold, seal

NOT_RUN = ("5A", "5B", "no-slip-force-driven")  # the fixture has no results of their recipe
JUDGED = [claim_id for claim_id in table() if claim_id not in NOT_RUN]
START = 1.7e9  # [s] since 1970
BUILD = "rupture 0.9.0, commit abc"

README = """# Title of {name} & <more>

What is done.

    load -o {name}.h5 --until 1.2
    analyze front {name}.h5

## Caption

The *slow* part takes <t_R>:

- **A**: it is slow; `front.csv`: how slow.
- **B**: [the README](README.md). Like [another](../figS3/README.md); [the README](README.md).
"""


def png(width, height):
    content = io.BytesIO()
    Image.new("RGB", (width, height), (64, 128, 192)).save(content, "png")
    return content.getvalue()


def spill(path, content):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content if isinstance(content, bytes) else content.encode())


SHARE = {"way": "primary", "holds": 7, "samples": 20, "runs": 20, "low": 0.2, "high": 0.53}


def result(claim_id):
    row = table()[claim_id]
    return {
        "id": claim_id,
        "paper": f"{row['says']} <b>",
        "measured": {"speed [m/s]": 12.345678, "list [mm]": [1.0, None]},
        "acceptance": row["accepted"],
        "kind": row["kind"],
        "fixed": row["fixed"],
        "shown": "does not hold" if claim_id == "S1" else "holds",
        "shares": [SHARE] if claim_id == "2A" else [],
        "reason": "holds as it should",
        "verdict": "differs" if claim_id == "S1" else "reproduced",
        "note": "Measured <script>twice</script>." if claim_id == "2A" else "",
    }


NUMBER = {"quantity": "l_0 [mm]", "paper": 7.0, "shown": 8.5, "most_like": None, "of": "9 fronts"}
NUMBER |= {"median": 8.4, "low": 8.0, "high": 9.0}


def results_of(claims):
    numbers = [NUMBER] if claims[0]["id"] == "3A" else []
    return {"schema": 3, "claims": claims, "numbers": numbers, "builds": []}


def job(own, command, started, seconds, **build):
    """What is known of a command."""
    known = {"id": own, "command": command, "inputs": {}, "started": int(START) + started}
    return known | {"seconds": seconds} | build


class Project:
    """At first, it has nothing but the page about claims."""

    def __init__(self, root):
        self.root = Path(root)
        self.results = self.root / "results"
        self.page = self.results / "index.html"
        hold(self.results).close()
        spill(self.root / "docs/claims.md", (ROOT / "docs/claims.md").read_bytes())

    def make_recipes(self):
        for name in {row["recipe"] for row in table().values()} | {"fig10"}:
            spill(self.root / f"recipes/{name}/commands.py", "")
            spill(self.root / f"recipes/{name}/README.md", README.format(name=name))
            claims = [result(claim) for claim in JUDGED if table()[claim]["recipe"] == name]
            if claims:
                results = self.results / name
                spill(results / "claims.json", json.dumps(results_of(claims)))
                spill(results / f"{name}.png", png(210, 80))
                spill(results / f".{name}.tmp.01234567.png", "half")
                spill(results / f"{name}.pdf", "%PDF")
                spill(results / "front.csv", "x\n")

    def make_accounts(self):
        """fig2 and fig3 need the same load."""
        load = job("ab12", "rupture load -o load.h5 --echo <b>", 0, 50, build=BUILD)
        load |= {"checksums": {"load.h5": "5eed5eed"}}
        self.spill_kept("ab/ab12.load.h5")
        read = {"inputs": {"load.h5": "ab12/load.h5"}}
        for n, name in enumerate(("fig2", "fig3")):
            peaks = job(f"cd{n}", "# in Python: slip.peaks_of load.h5", 60, 1) | read
            write_jobs(self.results / name, [load, peaks])
        write_jobs(self.results / "fig4", [load, {"id": "ef", "command": "rupture load"}])

    def seal(self):
        """All files are as ./reproduce.sh has written them."""
        files = (path for path in self.results.rglob("[!.]*") if path.is_file())
        apart = {self.results / MARKER.name, *self.results.glob("store/**/*")}
        seal(self.results, *(path for path in files if path not in apart))

    def spill_kept(self, name):
        spill(self.results / "store" / name, "a checkpoint")

    def report(self):
        """Makes the page: exit code, standard output and standard error."""
        said, errors, end = io.StringIO(), io.StringIO(), ""
        with redirect_stdout(said), redirect_stderr(errors):
            try:
                main(self.root)
            except SystemExit as failed:
                end = f"{failed}\n"
        return SimpleNamespace(
            returncode=int(end != ""), stdout=said.getvalue(), stderr=errors.getvalue() + end
        )
