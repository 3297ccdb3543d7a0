#!/usr/bin/env python3
"""The freeze of what decides a verdict (docs/frozen.md): prints the digest D, what it covers, and
the seeds and places that follow from D; compares them with recipes/frozen.toml. From the project's
folder:

    PYTHONPATH=recipes:python python3 -m claims.freeze

With --write, it freezes.
"""

import ast
import io
import json
import sys
import tokenize
import tomllib
from hashlib import sha256
from itertools import count
from pathlib import Path

from rupture.commands.code import blocks_with_docstrings
from rupture.errors import Failure
from rupture.replacing import write_whole

TABLE = Path("recipes/frozen.toml")
# What decides a verdict: claims and what measures them, programs, and the states to begin with.
COVERED = (
    "recipes/**/*.py",
    "recipes/**/*.toml",
    "python/rupture/**/*.py",
    "src/**/*",
    "include/**/*",
    "checkpoints/*.h5",
)
USED = ((1, 20), (201, 220), (401, 440), (501, 520), (701, 712))  # seeds of earlier rounds
RUNS, PREPARED = 20, 5  # seeds that are drawn
DIGITS = 6  # of shifts
HEAD = """\
# What the claims are judged on: seeds of runs and of prepared interfaces, and how far the grids of
# prestress and width are shifted, in steps. They follow from D, the digest of all that decides a
# verdict (docs/frozen.md). `python3 -m claims.freeze --write` wrote this file.
"""


# --- what is covered ---------------------------------------------------------------------------


def text_of_python(text):
    """Without comments, docstrings and blank lines. (By positions: how tokens and trees are printed
    depends on the version of Python.)"""
    lines = text.splitlines()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            row, column = token.start
            lines[row - 1] = lines[row - 1][:column]
    for docstring, *_ in blocks_with_docstrings(ast.parse(text)):
        first, last = docstring.lineno - 1, docstring.end_lineno - 1
        before = lines[first].encode()[: docstring.col_offset]
        after = lines[last].encode()[docstring.end_col_offset :]
        lines[first : last + 1] = [""] * (last - first) + [(before + after).decode()]
    return without_blank(lines)


def without_blank(lines):
    return "\n".join(line.rstrip() for line in lines if line.strip())


def covered_of(path):
    """The bytes of a file that count. In C++, a line that is a comment does not."""
    content = path.read_bytes()
    if path.suffix == ".h5":
        return content
    text = content.decode("utf-8")
    if path.suffix == ".py":
        text = text_of_python(text)
    elif path.suffix == ".toml":
        text = json.dumps(tomllib.loads(text), sort_keys=True, default=str)
    else:
        comment = "//" if path.suffix in (".cpp", ".hpp") else "# "
        lines = text.splitlines()
        text = without_blank(line for line in lines if not line.lstrip().startswith(comment))
    return text.encode()


def files_of(root):
    """{path: digest of what counts in it}"""
    paths = {path for pattern in COVERED for path in root.glob(pattern) if path.is_file()}
    names = sorted(path.relative_to(root).as_posix() for path in paths)
    return {
        name: sha256(covered_of(root / name)).hexdigest()
        for name in names
        if "__pycache__" not in name and name != TABLE.as_posix()
    }


def digest_of(files):
    """D"""
    lines = "".join(f"{digest}  {name}\n" for name, digest in files.items())
    return sha256(lines.encode()).hexdigest()


# --- what follows from D -----------------------------------------------------------------------


def numbers(digest, stream):
    """The numbers of a stream, from 0 to 2^256 - 1; the first has n = 1."""
    for n in count(1):
        yield int.from_bytes(sha256(f"{digest} {stream} {n}".encode()).digest(), "big")


def seeds(digest):
    """Below a million, none of them used before, each once."""
    found: dict[int, None] = {}
    for number in numbers(digest, "seeds"):
        seed = number % 10**6
        if seed and not any(first <= seed <= last for first, last in USED):
            found[seed] = None
        if len(found) == RUNS + PREPARED:
            return [*found]
    return []


def shift(digest, stream):
    """In steps: of prestress from -1/2 to 1/2, of the width from 0 to 1."""
    part = next(numbers(digest, stream)) / 2**256
    return round(part - 0.5 if stream.endswith("tau_bar") else part, DIGITS)


def derived(digest, streams):
    found = seeds(digest)
    shifts = {stream: shift(digest, stream) for stream in streams}
    return {"seeds": found[:RUNS], "prepared": found[RUNS:], "shifts": shifts}


# --- the file ----------------------------------------------------------------------------------


def read(root):
    return tomllib.loads((root / TABLE).read_text(encoding="utf-8"))


def text_of(digest, files, follows):
    listed = [
        f"[{name}]\n"
        + "".join(f"{json.dumps(key)} = {json.dumps(of)}\n" for key, of in rows.items())
        for name, rows in (("shifts", follows["shifts"]), ("changed_since", {}), ("files", files))
    ]
    values = [f"D = {json.dumps(digest)}", *(f"{n} = {follows[n]}" for n in ("seeds", "prepared"))]
    return HEAD + "\n".join([*values, "", *listed])


def problems(root):
    """Sentences about what is not as frozen; empty before a freeze."""
    table, files = read(root), files_of(root)
    if not table["D"]:
        return
    known, changed = table["files"], table["changed_since"]
    stated = {name: table[name] for name in ("seeds", "prepared", "shifts")}
    follows = derived(table["D"], table["shifts"])
    if digest_of(known) != table["D"] or json.dumps(follows) != json.dumps(stated):
        yield f"{TABLE}: the files, seeds and places are not those that follow from D."
    for name in sorted({*known, *files}):
        if files.get(name) != known.get(name) and not reason_of(changed.get(name)):
            yield f"{name} is not as frozen: give a reason and rows in [changed_since] of {TABLE}."
    if rows := sorted({row for of in changed.values() for row in of.get("rows", ())}):
        sentence = f"Changed since the freeze: {', '.join(rows)}."
        if sentence not in (root / "README.md").read_text(encoding="utf-8"):
            yield f"README.md does not say: {sentence}"


def reason_of(change):
    """A change has a reason and a list of rows, which may be empty."""
    return change and change.get("reason") and isinstance(change.get("rows"), list)


def shown(root):
    """Lines about what is."""
    table, files = read(root), files_of(root)
    digest = digest_of(files)
    follows = derived(digest, table["shifts"])
    yield f"D = {digest}, of {len(files)} files:"
    yield from (f"  {of[:16]}  {name}" for name, of in files.items())
    yield from (f"{name}: {of}" for name, of in follows.items())
    yield f"frozen: {table['D'] or 'nothing (the seeds are those of a rehearsal)'}"


def freeze(root):
    if read(root)["D"]:
        raise Failure(f"{TABLE} is frozen already; one version has one freeze.")
    files = files_of(root)
    digest = digest_of(files)
    write_whole(root / TABLE, text_of(digest, files, derived(digest, read(root)["shifts"])))


def main(arguments, root=Path()):
    if arguments == ["--write"]:
        freeze(root)
    for line in shown(root):
        print(line)
    found = [*problems(root)]
    print(*found, sep="\n", file=sys.stderr, end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
