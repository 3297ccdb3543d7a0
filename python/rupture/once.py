"""Commands as one types them, each done once:

    record = run(f"restart {base} -o end.h5 --for 0.01 --record record.h5")["record.h5"]
    front = run(f"analyze front {record} --event 0")          # its report: front.slow.speed
    peaks = measured(peaks_of, record)                        # of a Python function
    types = each(front_at, [(s, t) for s in sigmas for t in taus], "map")

A command is known by its words, by what its program computes with, and by what its input files are:
the bytes of the user's own files and, of a file that a command wrote, that command. So nothing runs
for a report that is there, and a file that is gone is made again when one is needed. It runs in a
folder of its own, in which its inputs have plain names: the words that are typed are the words that
run. A refusal is a result, too, with the program's sentence. Everything else is Python.

Results are in ./store, in $RUPTURE_STORE, or where use(store=...) says."""

import atexit
import os
import shutil
import signal
import sys
import time
from contextlib import contextmanager
from pathlib import Path

from rupture.commands.identity import Command, Files, Made, Measurement, Refused, Report
from rupture.commands.making import Making, Scope, Unknown
from rupture.commands.pool import Pool
from rupture.commands.processes import Local
from rupture.commands.store import Store, complain

__all__ = [
    "Made",
    "Refused",
    "Report",
    "Unknown",
    "asked",
    "each",
    "known",
    "measured",
    "run",
    "use",
]

making: Making | None = None


def use(store=None, cores=None, dry_run=None):
    """Says where results are, how many programs may run at a time, and whether commands are only
    printed. Without it: $RUPTURE_STORE or ./store, all cores, and as the words of the script say.
    """
    global making
    if making:
        finish()
    store = store or os.environ.get("RUPTURE_STORE") or os.environ.get("STORE") or "store"
    cores = cores or int(os.environ.get("CORES", 0)) or len(os.sched_getaffinity(0))
    dry_run = "--dry-run" in sys.argv if dry_run is None else dry_run
    executor = Local()
    making = Making(Store(store), executor, Pool(1 if dry_run else cores), dry_run)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup
            signal.signal(number, end)
    atexit.register(finish)
    return making


def finish():
    shutil.rmtree(making.store.now, ignore_errors=True)


def end(number, _):
    making.pool.stopped = True
    making.executor.stop()
    complain("interrupted: what is done is kept; the same call goes on from there")
    raise SystemExit(128 + number)


def folder_of_caller():
    """The folder of the recipe or script."""
    name = sys._getframe(2).f_globals.get("__file__")
    return Path(name).resolve().parent if name else Path.cwd()


def run(line, keep=()):
    """The report of `analyze`; the files of another program, not made yet. `keep`: those that stay
    when the point is done, because much work is in them or a picture needs them."""
    now = making or use()
    command = now.name(Command(line, folder_of_caller(), now.store), keep)
    return now.report(command) if command.is_analysis else Files(command, now.open)


def measured(function, *files):
    """What a Python function returns for these files, numbers and texts. It is known by the code
    of its module and of what that imports of ours, without comments."""
    now = making or use()
    return now.report(now.name(Measurement(function, files, folder_of_caller(), now.store)))


class Points(list):
    """(point, result) of those that worked; `refused`: (point, sentence) of others."""

    refused: list


def each(function, points, title="", only_known=False):
    """function(*point) of all points, side by side. What a point has named goes when it is done,
    but for what is kept. `only_known`: of what is in the store already."""
    now = making or use()
    points = [point if isinstance(point, tuple) else (point,) for point in points]
    around = Scope(now.scope, only_known)
    scopes = [Scope(around) for _ in points]
    since, done = time.monotonic(), iter(range(1, len(points) + 1))

    def one(number):
        try:
            return now.within(scopes[number], function, *points[number])
        except (Refused, Unknown) as why:
            return why
        except BaseException:
            around.is_cancelled = True
            raise
        finally:
            n = next(done)
            if title and scopes[number].has_run:
                complain(f"[{time.monotonic() - since:4.0f} s] {title}: {n} of {len(points)}")

    results = list(zip(points, now.pool.map(one, range(len(points)))))
    now.scope.asked += [command for scope in scopes for command in scope.asked]
    worked = Points(pair for pair in results if not isinstance(pair[1], (Refused, Unknown)))
    worked.refused = [(point, str(why)) for point, why in results if isinstance(why, Refused)]
    return worked


def known(function, points):
    """`each` for the points whose reports are all there. Nothing runs."""
    return each(function, points, only_known=True)


@contextmanager
def asked():
    """Yields a list that has in the end what was asked for within, in order: commands."""
    scope, log = (making or use()).scope, []
    begin = len(scope.asked)
    yield log
    log += dict.fromkeys(scope.asked[begin:])
