# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Files that are written as a whole or not at all."""

import os
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replacing(path):
    """A temporary path, whose file becomes that of `path` at the end."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def write_whole(path, text):
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
