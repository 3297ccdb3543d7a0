"""Commands as a script for the shell, with a folder for each."""

import os
import shlex

from rupture.commands.identity import Made

HEAD = """# All commands behind {title}. In an empty folder: bash commands.sh
set -e
"""
FILES = """: "${{FILES:?set it to the folder that has {names}}}"
"""


def with_sources(works):
    """These, each after those whose files it reads, once."""
    found = {}

    def add(work):
        if work.own not in found:
            for source in work.sources():
                add(source)
            found[work.own] = work

    for work in works:
        add(work)
    return list(found.values())


def script_of(works, title, root="/"):
    """A text for commands.sh; users' own files are named relative to `root`."""
    works = with_sources(works)
    folders = {one.own: f"{n:03}-{one.line.split()[0]}" for n, one in enumerate(works, 1)}
    lines, own_files = [], []
    for work in works:
        lines.append(f"\nmkdir {folders[work.own]} && cd {folders[work.own]}")
        for name, source in work.inputs.items():
            if isinstance(source, Made):
                path = f"../{folders[source.work.own]}/{source.name}"
            else:
                own_files.append(os.path.relpath(source, root))
                path = f'"$FILES"/{shlex.quote(own_files[-1])}'
            lines.append(f"ln -s {path} {shlex.quote(name)}")
        code = (work.making.store.result(work.own) or {}).get("code")
        lines += [f"{work.typed} || test $? = {code}" if code else work.typed, "cd .."]
    files = FILES.format(names=", ".join(dict.fromkeys(own_files))) if own_files else ""
    return HEAD.format(title=title) + files + "\n".join(lines) + "\n"
