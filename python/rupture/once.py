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
import signal
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

from rupture.commands.identity import Command, Made, Measurement, Refused
from rupture.commands.folder import complain
from rupture.commands.making import Making, Scope, Unknown, Untold
from rupture.commands.pool import Pool
from rupture.commands.processes import Local
from rupture.commands.progress import Progress
from rupture.commands.script import script_of
from rupture.commands.store import Onlooker, Report, Store
from rupture.commands.workers import SCHEDULER, Workers
from rupture.replacing import ENDING

__all__ = ["Made", "Refused", "Report", "Unknown"]
__all__ += ["asked", "each", "keep", "known", "measured", "run", "script_of", "use"]

current: list[Making] = []  # one, or none yet


def use(store=None, cores=None, dry_run=None, cap=None, executor=None, megabytes=None, threads=1):
    """Says where results are, how many programs run at a time, whether commands are only printed,
    how many bytes of files may be there that are not kept, what runs programs, and how much memory
    and how many threads each of them may need."""
    finish()
    dry_run = "--dry-run" in sys.argv if dry_run is None else dry_run
    cores, cap = (1, 1) if dry_run else (cores, cap)
    is_far = SCHEDULER in os.environ and not dry_run
    executor = executor or (Workers if is_far else Local)(megabytes, threads)
    place = (Onlooker if dry_run else Store)(store or os.environ.get("RUPTURE_STORE", "store"))
    current.append(Making(place, executor, Pool(cores or executor.cores), dry_run, cap))
    executor.watch((lambda _: None) if cores else current[0].pool.resize)
    for number in ENDING:
        if is_main() and signal.getsignal(number) != signal.SIG_IGN:  # as with nohup
            signal.signal(number, end)
    return current[0]


@atexit.register
def finish():
    """Files that are not kept go."""
    while current:
        current.pop().close()


def end(number, _):
    for making in current:
        making.stop()
    complain("interrupted: what is done is kept, and the same call goes on from there")
    sys.exit(128 + number)


def is_main():
    return threading.current_thread() is threading.main_thread()


def the_call():
    """This one; a new one after an interruption, in a notebook."""
    return current[0] if current and not (current[0].pool.stopped and is_main()) else use()


def work_of(kind, *words, keep=()):
    """A command or measurement of the recipe or script that asks for it."""
    making = the_call()
    file = sys._getframe(2).f_globals.get("__file__")
    work = kind(*words, making, Path(file).resolve().parent if file else Path.cwd())
    work.kept = {work[name].name for name in keep}
    return making.name(work)


def run(line, keep=()):
    """The report of `analyze`; the files of another program, not made yet. `keep`: those that stay
    when the point is done, because much work is in them or a picture needs them."""
    command = work_of(Command, line, keep=keep)
    return command.making.report(command) if command.has_report else command


def keep(*made):
    """Files that stay when their point is done, if something has needed them."""
    for one in made:
        one.work.kept.add(one.name)


def measured(function, *files):
    """What a Python function returns for these files, numbers and texts. It is known by the code
    of its module and of what that imports of ours, without comments."""
    work = work_of(Measurement, function, files)
    return work.making.report(work)


class Points(list):
    """(point, result) of those that worked; `refused`: (point, sentence) of others."""

    refused: list


def each(function, points, title="", only_known=False):
    """function(*point) of all points, side by side. What a point has named goes when it is done,
    but for what is kept. `only_known`: of what is in the store already."""
    making = the_call()
    points = [point if isinstance(point, tuple) else (point,) for point in points]
    around = Scope(making.scope, only_known)
    scopes = [Scope(around) for _ in points]
    progress = Progress(title, points, making.store)

    def one(number):
        since = time.monotonic()
        try:
            return making.within(scopes[number], function, points[number])
        except (Refused, Unknown) as why:
            return why
        except BaseException:
            around.is_cancelled = True
            raise
        finally:
            progress.add(number, time.monotonic() - since, scopes[number].has_run)

    numbers = range(len(points))
    results = list(map(one, numbers) if only_known else making.pool.map(one, numbers))
    progress.end(str(result) for result in results if isinstance(result, Refused))
    unknown = [isinstance(result, Unknown) for result in results]
    if any(unknown) and making.scope.only_known:
        raise Unknown  # half of what is asked for is not what is asked for
    if any(unknown) and making.dry_run and not only_known:
        if making.scope.parent is None:
            wait = f"{sum(unknown)} of {len(points)} points wait for what a report will say"
            making.show(f"# {title or 'each'}: {wait}")
        return Untold()
    making.scope.asked += [
        work for scope, is_unknown in zip(scopes, unknown) if not is_unknown for work in scope.asked
    ]
    pairs = list(zip(points, results))
    worked = Points(pair for pair in pairs if not isinstance(pair[1], (Refused, Unknown)))
    worked.refused = [(point, str(why)) for point, why in pairs if isinstance(why, Refused)]
    return worked


def known(function, points, title=""):
    """`each` for the points whose reports are all there. Nothing runs."""
    return each(function, points, title, only_known=True)


@contextmanager
def asked():
    """Yields a list, in which is in the end what was asked for within: commands, in order."""
    scope = the_call().scope
    log: list[Command | Measurement] = []
    begin = len(scope.asked)
    yield log
    log += dict.fromkeys(scope.asked[begin:])
