"""golden: regression tests by content checksums (docs/regression-tests.md)."""

import fcntl
import itertools
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from rupture.errors import Failure
from rupture.replacing import write_whole
from rupture.tools.command_line import Parser

SKIPPED = 77


def parse_options():
    made = Parser(
        "golden check|regenerate [options] GOLDEN PIPELINE [ARGUMENT...]",
        "Runs a pipeline, any program, in a fresh folder, with rupture and its tools on its PATH."
        " Compares the content checksums of the files *.h5 that it writes there with those in"
        " GOLDEN (check), or makes them the new GOLDEN and keeps the old one as GOLDEN.old1, .old2"
        " and so on (regenerate). Exit code: 0 equal or written, 1 different or failed, 77 if the"
        " pipeline exited with 77 because it cannot run on this machine.",
        "word",
    )
    made.add_argument(
        "command", metavar="COMMAND", choices=("check", "regenerate"), help="check or regenerate"
    )
    text = "the folder of the tools (default: that of this program)"
    made.add_argument("--tools", metavar="FOLDER", help=text)
    text = (
        "keep the files of the last run that agreed with GOLDEN in FOLDER/equal, and those of the"
        " last run that did not in FOLDER/found (default: <name of GOLDEN>.files)"
    )
    made.add_argument("--work", metavar="FOLDER", help=text)
    made.add_argument("golden", metavar="GOLDEN", type=Path, help="file with the checksums")
    made.add_argument("program", metavar="PIPELINE", help="program or script to run")
    arguments = made.add_argument("arguments", metavar="ARGUMENT", nargs="...", help="of PIPELINE")
    arguments.required = False
    return made.parse_args()


def regenerate_command():
    at = sys.argv.index("check")  # options may stand before it
    return shlex.join([*sys.argv[:at], "regenerate", *sys.argv[at + 1 :]])


def take(work):
    """Returns the open lock. Only one run at a time may use the folder, and only what such runs
    made in it is ever deleted."""
    lock = work / "rupture-golden.lock"
    other = "give another folder with --work"
    if not lock.exists() and ((work / "found").exists() or (work / "equal").exists()):
        raise Failure(f"{work} has a 'found' or 'equal' that another program made: {other}")
    try:
        work.mkdir(parents=True, exist_ok=True)
        taken = os.fdopen(os.open(lock, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666))
        fcntl.flock(taken, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except PermissionError as error:
        raise Failure(f"cannot write {error.filename}: no write permission; {other}") from None
    except BlockingIOError:
        raise Failure(f"another run uses {work}: wait for it, or {other}") from None
    return taken


def run_pipeline(pipeline, tools, folder):
    path = f"{tools}:{tools}/../../bin:{os.environ.get('PATH') or os.defpath}"
    program = shutil.which(pipeline[0], path=path)
    if not program:
        hint = "give a program, or make it executable with chmod +x"
        raise Failure(f"the pipeline {pipeline[0]} cannot be run: {hint}")
    words = [os.path.abspath(program), *pipeline[1:]]  # it is run in another folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    environment = os.environ | {"PATH": path}
    code = subprocess.call(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL)
    if code == SKIPPED:
        sys.exit(code)
    said = " ".join(words)
    if code:
        wrote = f"its files are in {folder}"
        raise Failure(f"the pipeline failed with exit code {code}: {said}; {wrote}")
    if not list(folder.rglob("*.h5")):
        raise Failure(f"the pipeline wrote no *.h5 in its working folder: {said}")


def verify(tools, folder, *words):
    """What `analyze verify` says of the files in a folder: whether all is well, and its lines."""
    command = [tools / "analyze", "verify", *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if not done.stdout:
        raise Failure(done.stderr.strip().removeprefix("analyze: "))
    return done.returncode == 0, done.stdout.splitlines()


def keep_as_equal(work):
    shutil.rmtree(work / "equal", ignore_errors=True)
    (work / "found").rename(work / "equal")


def advise(differing, manifest, work, tools):
    """Prints how to compare the files, if those that agreed with this golden file are there."""
    print(f"The files of this run are in {work}/found.")
    equal = work / "equal" / manifest.name
    if differing and equal.exists() and equal.read_bytes() == manifest.read_bytes():
        print("To see what differs:")
        for name in differing:
            files = work / "equal" / name, work / "found" / name
            print(" ", shlex.join(map(str, (tools / "analyze", "diff", *files))))
    else:
        print(
            "To compare files with 'analyze diff', first run this once with a version that passes."
        )
    print(f"If the change is intended:\n  {regenerate_command()}")


def check(golden, before, work, tools):
    manifest = work / "found" / golden.name  # it names files relative to itself
    write_whole(manifest, before)
    is_equal, lines = verify(tools, manifest.parent, "--manifest", golden.name, ".")
    if is_equal:
        keep_as_equal(work)
        return print(f"All content checksums are equal: {lines[-1]}.")
    print(*(line for line in lines if not line.startswith("intact ")), sep="\n")
    advise(
        re.findall("^differs  (.*) is intact but", "\n".join(lines), re.M), manifest, work, tools
    )
    return sys.exit(1)


def regenerate(golden, before, work, tools):
    found = work / "found"
    names = sorted(str(file.relative_to(found)) for file in found.rglob("*.h5"))
    intact, lines = verify(tools, found, *names)
    if not intact:
        raise Failure(f"{golden} was not changed, because in {found} are: {lines[-1]}")
    text = "".join(f"{line.removeprefix('intact  ')}\n" for line in lines[:-1])
    write_whole(found / golden.name, text)
    keep_as_equal(work)
    if before == text:
        return print(f"{golden} is current: nothing to change.")
    if golden.exists():
        others = (Path(f"{golden}.old{number}") for number in itertools.count(1))
        old = next(name for name in others if not os.path.lexists(name))
        shutil.copy2(golden, old)
        print(f"kept the old checksums as {old}")
    write_whole(golden, text)
    return print(f"wrote {golden}; content checksums: {len(lines) - 1}")


def run():
    options = parse_options()
    tools = Path(options.tools or os.path.dirname(sys.argv[0])).resolve()
    if not os.access(tools / "analyze", os.X_OK):
        raise Failure(f"no rupture tools in {tools}: give their folder with --tools")
    golden = options.golden.absolute()
    work = Path(options.work or f"{golden.name}.files").resolve()
    try:
        before = golden.read_text(encoding="utf-8") if golden.exists() else None
    except (UnicodeDecodeError, IsADirectoryError):
        raise Failure(f"{golden} is not a golden file: give the path of a text file") from None
    if options.command == "check" and before is None:
        raise Failure(f"there is no golden file {golden}; write it with: {regenerate_command()}")
    if options.command == "check":  # before a long run: raises Failure if it is no manifest
        verify(tools, golden.parent, "--manifest", golden.name)
    with take(work):
        run_pipeline([options.program, *options.arguments], tools, work / "found")
        if options.command == "check":
            check(golden, before, work, tools)
        else:
            regenerate(golden, before, work, tools)
