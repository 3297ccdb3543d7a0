"""All that these pages print is typed in one folder, in this order. A slider of fewer blocks,
driven faster, takes the place of the reference: runs take seconds."""

import os
import re
import subprocess
import sys
from pathlib import Path

from conftest import BIN, ROOT, need, need_modules

need("ffmpeg")
need_modules("pandas")
PAGES = ("README", "docs/tutorial", "docs/runs", "docs/pictures", "docs/sweeps", "docs/python")
SKIP = ("export ", "paraview ")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n|((?:^    [^\n]*\n)+)", re.MULTILINE | re.DOTALL)
SEEDS = re.compile("1 to [35]")
FEWER = """[slider]
Nx = 17
Nz = 9
H = 0.07
[driving]
h = 0.00875
V = 1e-3
[numerics]
dt = 5e-7
seed = 36
"""
PROGRAMS = {
    "load": f'exec {BIN}/load --config "${{0%/*}}/fewer.ini" "$@"',
    "movie": f'exec {BIN}/movie --frames 5 "$@"',
    "rupture": 'exec "${0%/*}/$1" "${@:2}"',
    "../reproduce.sh": f'exec {BIN}/rupture reproduce "$@"',
}


def commands_of(page):
    """A command for each line in the shell, and one for each block in Python. The file of a sweep
    is written, with one seed. The README's first blocks set the project up, which other tests do.
    """
    text = (ROOT / f"{page}.md").read_text("utf-8")
    before, _, after = text.partition("## Your own experiments\n")
    commands = []
    for language, code, indented in BLOCK.findall(after or before):
        if language == "python":
            commands.append([sys.executable, "-c", code])
        elif language == "ini" and "[sweep]" in code:
            Path("my.ini").write_text(SEEDS.sub("1", code), "utf-8")
        lines = (line.strip() for line in re.sub(r"\\\n *", "", indented).splitlines())
        commands += [["bash", "-c", line] for line in lines if line and not line.startswith(SKIP)]
    assert commands, page
    return commands


def test_what_is_printed_can_be_typed_in_one_folder(folder, monkeypatch):
    (folder / "checkpoints").symlink_to(ROOT / "checkpoints")
    bin_folder = folder / "docs/examples/bin"
    bin_folder.mkdir(parents=True)
    for program in BIN.iterdir():
        (bin_folder / program.name).symlink_to(program)
    for name, text in PROGRAMS.items():
        (bin_folder / name).unlink(missing_ok=True)
        (bin_folder / name).write_text(f"#!/bin/bash\n{text}\n")
        (bin_folder / name).chmod(0o755)
    (bin_folder / "fewer.ini").write_text(FEWER)
    monkeypatch.setenv("PATH", f"{bin_folder}:{os.environ['PATH']}")
    monkeypatch.setenv("RUPTURE_BIN", str(bin_folder))
    monkeypatch.chdir(bin_folder.parent)
    for page in PAGES:
        for words in commands_of(page):
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            wanted = 1 if "analyze diff " in words[2] else 0
            assert done.returncode == wanted, (page, words[2], done.stdout[-500:] + done.stderr)


def test_the_example_of_branches_begins(folder):
    """All of it takes a minute."""
    words = [sys.executable, f"{ROOT}/docs/examples/branches.py", "--dry-run"]
    done = subprocess.run(words, capture_output=True, text=True, check=True, cwd=folder)
    assert done.stdout.splitlines()[1:] == ["rupture analyze events r.h5"], done.stderr
