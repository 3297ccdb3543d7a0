"""Programs of the package as a user runs them."""

import json
from pathlib import Path

from conftest import run


def draws(name, *arguments, **options):
    """Whether it succeeds and only says what it wrote."""
    done = run(name, *arguments, **options)
    output = Path(arguments[arguments.index("-o") + 1])
    written = [output.with_name(f"{output.stem}-derived.hdf5")] if name == "xdmf" else []
    said = "".join(f"wrote {path}\n" for path in (*written, output))
    assert (done.returncode, done.stdout, done.stderr) == (0, said, "")


def refuses(name, arguments, code, part, **options):
    """With this exit code and this part of the sentence, which is the only one. Nothing is left
    behind."""
    before = sorted(Path().rglob("*"))
    done = run(name, *arguments, **options)
    assert sorted(Path().rglob("*")) == before
    found = (done.returncode, done.stdout, done.stderr.count("\n"))
    assert found == (code, "", 1), done.stderr
    assert done.stderr.startswith(f"rupture {name}: ") and part in done.stderr


def describes_itself(name):
    """--help and --describe name the same options."""
    described = json.loads(run(name, "--describe").stdout)
    assert described["name"] == name
    text = run(name, "--help").stdout
    assert all("--" + option["name"] in text for option in described["options"])
    assert "rupture" in run(name, "--version").stdout
