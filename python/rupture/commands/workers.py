"""Runs the programs of commands on the workers of a Dask scheduler, on any number of machines."""

import logging
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from math import inf
from contextlib import suppress

from rupture.commands.folder import complain
from rupture.commands.machine import ROOM
from rupture.commands.processes import APART, WITH_US
from rupture.errors import Failure, MachineFailure

SCHEDULER = "RUPTURE_SCHEDULER"  # the file that `dask scheduler --scheduler-file` writes
WITHIN = 60  # [s] a scheduler and its first worker start
PAUSE = 5  # [s] until workers are counted again
TOLD = ("RUPTURE_BIN", "PATH", "PYTHONPATH", "OMP_NUM_THREADS")  # variables that programs need
INSTALL = f"{SCHEDULER} needs Dask: sudo apt-get install python3-distributed"


def make_job():
    """What a worker does. A function within another is sent with its code, so that workers need
    nothing of ours, and what it names here goes with it."""

    def job(words, folder, inputs, variables):
        """Runs a program in a folder of its own on the worker's disk, and then gives what it wrote
        its place. So a second try finds nothing that a killed worker has left."""
        from distributed import get_worker

        worker = get_worker()
        task = worker.state.tasks[worker.get_current_task()]
        with tempfile.TemporaryDirectory(dir=worker.local_directory) as own:
            for name in inputs:
                try:
                    os.symlink(os.path.realpath(f"{folder}/{name}"), f"{own}/{name}")
                except OSError:  # a file system without links
                    shutil.copyfile(f"{folder}/{name}", f"{own}/{name}")
            prefix = WITH_US if shutil.which(WITH_US[0]) else []
            process = subprocess.Popen(
                [*prefix, *words], cwd=own, env=os.environ | variables, **APART
            )
            while process.returncode is None:
                try:
                    output, said = process.communicate(timeout=0.2)
                except subprocess.TimeoutExpired:
                    # the call has ended, or the scheduler
                    if task.state != "executing" or worker.status.name in ("closing", "closed"):
                        os.killpg(process.pid, signal.SIGKILL)
            for name in {*os.listdir(own)} - {*inputs}:
                part = f"{folder}/.{os.path.basename(own)}"
                shutil.move(f"{own}/{name}", part)
                os.replace(part, f"{folder}/{name}")
        return process.returncode, output, said.strip()

    return job


def programs_of(worker, megabytes, threads):
    """How many at a time."""
    limit = worker["memory_limit"] or inf  # [bytes]
    return max(1, min(worker["nthreads"] // threads, limit // 2**20 // megabytes))


class Workers:
    """Those that know a scheduler from the same file as we do."""

    where = " of Dask workers"

    def __init__(self, megabytes=None, threads=1):
        try:
            import distributed
        except ImportError:
            raise Failure(INSTALL) from None
        self.dask, self.megabytes, self.threads = distributed, megabytes or ROOM, threads
        self.file = os.path.abspath(os.environ[SCHEDULER])
        for name in ("distributed.client", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL)  # we say what happens
        self.job, self.ended = make_job(), threading.Event()
        self.client = self.connect()

    def connect(self):
        """Raises Failure if there is no scheduler, or no worker."""
        begun = time.monotonic()
        while not os.path.exists(self.file):
            if time.monotonic() > begun + WITHIN:
                raise Failure(
                    f"there is no {self.file}: start dask scheduler --scheduler-file {self.file}"
                )
            time.sleep(0.1)
        client = None
        try:
            client = self.dask.Client(
                scheduler_file=self.file, set_as_default=False, timeout=WITHIN
            )
            client.wait_for_workers(1, timeout=WITHIN)
        except (OSError, ValueError, TimeoutError) as error:
            missing = f"no worker comes to the scheduler of {self.file}: start dask worker"
            dead = f"the scheduler of {self.file} does not answer: start it again"
            raise Failure(missing if client else dead) from error
        return client

    def programs(self):
        """How many each worker runs at a time."""
        workers = self.client.scheduler_info()["workers"].values()
        return [programs_of(one, self.megabytes, self.threads) for one in workers]

    @property
    def cores(self):
        """As many as workers have threads, if there is memory for as many programs."""
        return max(1, sum(self.programs()))

    def watch(self, resize):
        """Workers come and go. If all have gone, it says so, once."""

        def count():
            had_workers = True
            while not self.ended.wait(PAUSE):
                with suppress(OSError, KeyError):  # no scheduler: commands say so
                    programs = self.programs()
                    resize(max(1, sum(programs)))
                    has_workers = bool(programs)
                    if had_workers and not has_workers:
                        complain(
                            f"waiting for workers: none is left at the scheduler of {self.file}"
                        )
                    had_workers = has_workers

        threading.Thread(target=count, daemon=True).start()

    def run(self, words, folder):
        variables = {"OMP_NUM_THREADS": str(self.threads)}
        variables |= {name: os.environ[name] for name in TOLD if name in os.environ}
        try:
            plain = [str(word) for word in words]  # workers do not know subclasses of ours
            given = plain, str(folder), os.listdir(folder), variables
            return self.client.submit(self.job, *given, pure=False).result()
        except self.dask.KilledWorker:
            raise Failure(f"{words} has ended several workers: give them more memory") from None
        except self.dask.CancelledError:
            again = "start scheduler and workers again, and the same call goes on from there"
            raise MachineFailure(f"the scheduler of {self.file} has ended: {again}") from None

    def stop(self):
        self.ended.set()

    def close(self):
        """The scheduler takes back what has begun, and its workers end these programs."""
        self.client.close()
