"""Sources as a digest: results that were made with others are out of date."""

import hashlib
from pathlib import Path

SOURCES = ("include", "src", "cmake", "CMakeLists.txt")
PROGRAMS = ("analyze", "load", "modify-phi", "prepare", "restart")


def fingerprint(*folders_and_files):
    """SHA-256 of the names and contents of files, wherever they are."""
    digest = hashlib.sha256()
    for top in map(Path, folders_and_files):
        for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
            if path.is_file():
                name = path.relative_to(top.parent)
                digest.update(f"{name}\0{path.stat().st_size}\0".encode())
                digest.update(path.read_bytes())
    return digest.hexdigest()


def fingerprint_of_programs(folder=None):
    """Of what the programs are built from here, or of the programs that are in `folder`."""
    return fingerprint(*([Path(folder) / name for name in PROGRAMS] if folder else SOURCES))
