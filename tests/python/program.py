"""Programs of the package as a user runs them."""

from pathlib import Path

from conftest import run


def draws(name, *arguments, **options):
    """Whether it succeeds and only says what it wrote."""
    done = run(name, *arguments, **options)
    output = Path(arguments[arguments.index("-o") + 1])
    written = [output.with_name(f"{output.stem}-derived.hdf5")] if name == "xdmf" else []
    said = "".join(f"wrote {path}\n" for path in (*written, output))
    assert (done.returncode, done.stdout, done.stderr) == (0, said, "")
