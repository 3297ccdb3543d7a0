"""The places of files, and how the commands print."""

import atexit
import errno
import os
import shutil
import tempfile
from contextlib import suppress
from functools import cache
from pathlib import Path

from rupture.commands.folder import HOLDS_LINKS
from rupture.errors import Failure
from rupture.tools import command_line

SHARE = Path(__file__).resolve().parents[2]  # recipes and what they read
# `rupture reproduce` names the folder for results. Elsewhere they are beside the recipes.
WORK = Path(os.environ["RUPTURE_WORK"]) if "RUPTURE_WORK" in os.environ else None
ROOT = WORK / ".rupture" if WORK else SHARE
RESULTS = Path("results")
STORE = RESULTS / "store"  # may be a link
LOGS = Path("build/log")
PROGRAMS = Path("build/release/bin")
READ = ("recipes", "python", "checkpoints", "docs", "benchmarks", "CITATION.cff")
# Recipes that `all` leaves out: they judge no claim and take long.
BESIDE_ALL = ("barrier", "choices", "convergence", "places", "speeds")


def refuse_links(paths):
    for path in paths:
        if path.is_symlink():
            raise Failure(f"{os.fspath(path)} {HOLDS_LINKS}")


def link_to(target, link):
    """Where a folder has no links, results are within, and what recipes read is not."""
    try:
        link.symlink_to(target)
    except OSError as error:
        without = (errno.EPERM, errno.EOPNOTSUPP, errno.ENOSYS)
        if link.name == "results" and (error.errno in without or link.is_dir()):
            link.mkdir(exist_ok=True)
        elif error.errno not in without:
            raise


def enter_root():
    """Enters the folder of recipes and results. For `rupture reproduce`, it has links to both, and
    no others, which might lead to files of the user."""
    if WORK:
        try:
            targets = {"results": Path("../results")} | {name: SHARE / name for name in READ}
            inside = (Path(at, one) for at, *names in os.walk(ROOT) for one in sum(names, []))
            refuse_links((ROOT, *(one for one in inside if one not in map(ROOT.joinpath, targets))))
            ROOT.mkdir(exist_ok=True)
            (WORK / "results").mkdir(exist_ok=True)
            for name, target in targets.items():
                link = ROOT / name
                if link.is_symlink() and link.readlink() != target:
                    link.unlink()
                if not link.is_symlink():
                    link_to(target, link)
        except OSError as error:
            where = error.filename2 or error.filename
            raise Failure(f"{where} cannot be written ({error.strerror}).") from None
    os.chdir(ROOT)


@cache
def folder_for_matplotlib():
    """In the user's own cache, else a new one until the end. Matplotlib evaluates styles that it
    finds there, so it is not below ROOT, which anybody may have made."""
    named = os.environ.get("XDG_CACHE_HOME", ""), os.path.expanduser("~/.cache")
    own = Path(next(filter(os.path.isabs, named), os.devnull))
    folder = own / "rupture/matplotlib"
    with suppress(OSError):
        for one in (own, folder.parent, folder):
            one.mkdir(mode=0o700, exist_ok=True)
        if os.access(folder, os.W_OK | os.X_OK):
            return str(folder)
    temporary = tempfile.mkdtemp(prefix="rupture-")
    atexit.register(shutil.rmtree, temporary, ignore_errors=True)
    return temporary


def use_own_environment():
    """Ignores Matplotlib's settings and, with Debian's packages, Python's modules of the user."""
    if os.path.isdir("/usr/lib/python3/dist-packages/h5py"):
        os.environ["PYTHONNOUSERSITE"] = "1"
    os.environ.update(MATPLOTLIBRC=os.devnull, MPLCONFIGDIR=folder_for_matplotlib())


def say(text=""):
    """Prints at once, before the programs that are started next."""
    print(text, flush=True)


def complain(text):
    command_line.complain("reproduce" if WORK else "reproduce.sh", str(text).rstrip("."))
