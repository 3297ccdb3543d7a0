"""A user's sweep, by Ninja: ./reproduce.sh sweep FILE.ini."""

import json
import os
import shutil
import sys

from chains.plan import write_plan
from chains.progress import STATUS, follow
from chains.store import RESULTS, STORE, put_back
from chains.sweeps import OwnSweep
from chains.table import preview, report_sweep
from reproduce.compute import prepare, write_crate
from reproduce.project import PROGRAMS, ROOT
from report.written import seal, written
from rupture.commands.machine import usable_megabytes
from rupture.errors import Failure


def run_ninja(processes, cores, own, file):
    """Makes its points by a plan, which Ninja may write again."""
    wanted = {"file": file, "cores": cores, "megabytes": usable_megabytes()}
    try:
        plan = write_plan(**wanted, own=own)
    except OSError as error:
        raise Failure(f"{ROOT / RESULTS} cannot be written ({error.strerror})") from None
    if not shutil.which("ninja"):
        raise Failure("there is no program ninja on the PATH; packages.txt names its package")
    os.environ |= {"RUPTURE_PLAN": json.dumps(wanted), "RUPTURE_PYTHON": sys.executable}
    os.environ |= {"RUPTURE_STEP": "sh", "NINJA_STATUS": STATUS}
    ninja = ["ninja", "-f", plan, "-j", cores, "-k", 0]
    try:
        processes.run(ninja, follow)
    finally:
        put_back()


def run_sweep(request, processes):
    """Writes the table even if points could not be computed; it states which, and why."""
    prepare(request, processes)
    own = OwnSweep(request.file)
    if request.dry_run:
        preview(own, request.programs or PROGRAMS)
        return 0
    if processes.has_turn:
        put_back()  # of a run that was killed
    own.write()
    there, count = {*STORE.glob("*.json")}, len(own.missing())
    run_ninja(processes, request.cores, own, str(request.file))
    if own.points is None:
        own = OwnSweep(request.file)
        if own.points is None:
            raise Failure(f"{request.file}: its points follow from others, which were not computed")
        own.write()
        count = len([point for point in own.points if point.path not in there])
    code = report_sweep(own.sweep, count)
    ours = [path for path in map(RESULTS.joinpath, written(RESULTS)) if path.is_file()]
    seal(RESULTS, *(path for path in ours if path.parent == own.stem.parent))
    write_crate(processes)
    return code
