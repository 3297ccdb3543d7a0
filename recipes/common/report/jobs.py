"""The jobs that Snakemake ran, as runs/progress.py noted them in results/jobs.jsonl: rule, command,
inputs, outputs, start and time of each job."""

import json
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Job:
    rule: str
    command: str
    started: float  # [s] since 1970
    seconds: float


@dataclass(frozen=True)
class Step:
    """All jobs of one rule."""

    rule: str
    jobs: list

    @property
    def seconds(self):
        return total(self.jobs)


def total(jobs):
    return sum(job.seconds for job in jobs)


def steps(jobs):
    """Jobs by rule, in the order in which the rules came first."""
    by_rule: dict[str, list] = {}
    for job in jobs:
        by_rule.setdefault(job.rule, []).append(job)
    return [Step(rule, rule_jobs) for rule, rule_jobs in by_rule.items()]


def read_accounts(path):
    """{output: what is noted of the job that made it last}"""
    accounts: dict[str, dict] = {}
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    for line in lines:
        try:
            job = json.loads(line)
        except ValueError:
            continue  # its end is missing: the run was killed
        accounts |= {output: job for output in job["output"]}
    return accounts


class Accounts:
    def __init__(self, root):
        self.by_output = read_accounts(Path(root) / "results/jobs.jsonl")

    def files_behind(self, recipe):
        """The results of a recipe and all files they were made from, directly or not."""
        waiting = [path for path in self.by_output if path.startswith(f"results/{recipe}/")]
        found = set(waiting)
        while waiting:
            inputs = self.by_output.get(waiting.pop(), {}).get("input", [])
            new = set(inputs) - found
            found |= new
            waiting.extend(new)
        return found

    def jobs(self, files):
        """The jobs that made the files, in the order in which they started."""
        accounts = [self.by_output[path] for path in files if path in self.by_output]
        found = {(job["rule"], *job["output"]): job for job in accounts}
        jobs = [
            Job(job["rule"], job["command"], job["started"], job["seconds"])
            for job in found.values()
        ]
        return sorted(jobs, key=lambda job: (job.started, job.rule))
