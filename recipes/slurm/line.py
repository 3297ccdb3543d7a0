"""The commands that wait to become jobs, and the jobs that run."""

import math
import re
import threading
import time

from slurm.job import Job
from slurm.queue import cancel, end_leftovers, jobs_of

GROUPED = {"point"}  # rules with many short commands
GATHERING = 1.0  # [s] without a new command, after which a group is complete
GATHERING_AT_MOST = 5.0  # [s]
TEND_EVERY = 30.0  # [s]
TELL_EVERY = 5.0  # [s]
SHOWN = 3  # names of jobs
NEVER = re.compile(  # reasons for which a job waits in vain
    r"Partition(Time|Node)Limit|PartitionConfig|BadConstraints|(Assoc|QOS)\w*Max(Wall|Cpu|Mem|Node)\w*Per"
)
ATTEMPTS = 3  # of a command whose job SLURM ends


class Line:
    """Commands that wait to become jobs."""

    def __init__(self, settings):
        self.settings = settings
        self.commands = set()  # all that have not ended
        self.groups = {}  # Needs: commands that wait
        self.refused = {}  # Needs: the job for which SLURM said so
        self.running = {}  # name: job
        self.started = 0
        self.ended = 0  # commands
        self.closed = False
        self.changed = threading.Condition()

    def open(self):
        self.settings.logs.mkdir(parents=True, exist_ok=True)
        end_leftovers(self.settings.folder)
        for task in (self.serve, self.tend, self.tell):
            threading.Thread(target=task, daemon=True).start()

    def run(self, command):
        """The command's exit code, when it has ended."""
        with self.changed:
            self.commands.add(command)
            self.add(command)
        if not self.closed:
            command.ended.wait()
        if self.closed:
            raise KeyboardInterrupt
        with self.changed:
            self.commands.remove(command)
            self.ended += 1
        return command.code

    def add(self, command):
        if refusal := self.refused.get(command.needs):
            return self.give_up(command, refusal)
        command.attempts += 1
        command.since = time.monotonic()
        self.groups.setdefault(command.needs, []).append(command)
        self.changed.notify()

    def close(self):
        """Nothing is started any more, and what runs is ended. For a signal: it takes no lock."""
        self.closed = True
        for command in list(self.commands):
            command.ended.set()
        for job in list(self.running.values()):
            job.interrupt()

    def serve(self):
        while True:
            with self.changed:
                while not (commands := self.next_group()):
                    self.changed.wait(GATHERING / 4 if self.groups else None)
                self.started += 1
                job = Job(self.settings, self.started, commands)
                self.running[job.name] = job
            threading.Thread(target=self.start, args=[job], daemon=True).start()

    def start(self, job):
        try:
            job.run()
        except OSError as error:  # such as a full disk
            print(f"{job.name}: {error}", flush=True)
            for command in job.left():
                command.end(1)
        finally:
            with self.changed:
                del self.running[job.name]
                self.settle(job)
                self.changed.notify()

    def tend(self):
        """Ends jobs whose srun has ended while the controller could not be reached: they would keep
        their cores until their time is up. Says which jobs will never start."""
        before, told = set(), set()
        while True:
            time.sleep(TEND_EVERY)
            jobs = jobs_of(self.settings.folder) or []
            idle = {job.number for job in jobs if not self.is_mine(job)}
            cancel(sorted(idle & before))
            before = idle
            for job in jobs:
                if NEVER.search(job.reason) and job.number not in told:
                    told.add(job.number)
                    print(f"{job.name} cannot start: {job.reason} (docs/cluster.md)", flush=True)

    def is_mine(self, job):
        return job.run == self.settings.run and job.name in self.running

    def tell(self):
        """What is going on, as long as it changes."""
        opened, told = time.monotonic(), ""
        while True:
            time.sleep(TELL_EVERY)
            now = self.state()
            if now != told:
                print(f"[{time.monotonic() - opened:4.0f} s] {now}", flush=True)
            told = now

    def state(self):
        with self.changed:
            jobs = list(self.running.values())
            waiting = sum(map(len, self.groups.values()))
        run = [job.name for job in jobs if job.begun]
        names = f" ({', '.join(run[:SHOWN])}{', ...' if len(run) > SHOWN else ''})" if run else ""
        queued = len(jobs) - len(run)
        of_jobs = f"jobs: {len(run)} running{names}, {queued} in the queue"
        return f"{self.ended} done; {of_jobs}; {waiting} waiting"

    def settle(self, job):
        """What SLURM has ended is tried again."""
        left = job.left()
        if self.closed or not left:
            return
        if job.is_refused():
            self.refused[job.needs] = job
            left += self.groups.pop(job.needs, [])
            print(f"SLURM refused {job.name}: {job.reason()}", flush=True)
        again = [command for command in left if self.may_try_again(command)]
        if again:
            print(
                f"SLURM ended {job.name} ({job.reason()});"
                f" {len(again)} of its {len(job.commands)} commands wait again",
                flush=True,
            )
        for command in left:
            if command not in again:
                self.give_up(command, job)
                continue
            if job.had_too_little():
                command.ask_for_more()
            self.add(command)

    def may_try_again(self, command):
        return command.attempts < ATTEMPTS and command.needs not in self.refused

    def give_up(self, command, job):
        """The rule's own log says why."""
        try:
            for path in command.log:
                with open(path, "a", encoding="utf-8") as log:
                    print(f"SLURM ended the job ({job.log}):\n{job.last_words()}", file=log)
        finally:
            command.end(1)

    def next_group(self):
        """Takes the commands of the next job out of the line, if there may be one now."""
        free = self.settings.jobs - len(self.running)
        for needs, waiting in self.groups.items():
            if free > 0 and not self.closed and self.is_gathered(needs, waiting):
                size = self.group_size(needs, len(waiting), free)
                group, self.groups[needs] = waiting[:size], waiting[size:]
                if not self.groups[needs]:
                    del self.groups[needs]
                return group
        return []

    def is_gathered(self, needs, waiting):
        now = time.monotonic()
        return (
            needs.rule not in GROUPED
            or now - waiting[-1].since > GATHERING
            or now - waiting[0].since > GATHERING_AT_MOST
        )

    def group_size(self, needs, waiting, free):
        """Commands are shared out among all jobs that may still start."""
        if needs.rule not in GROUPED:
            return 1
        longest = max(1, self.settings.group_time // needs.time)
        return min(math.ceil(waiting / free), self.settings.group, longest)
