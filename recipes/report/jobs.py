"""What Snakemake ran, from the account it keeps of every output in .snakemake/metadata: command,
inputs, start and end. (7.21 names each file there after the output, in URL-safe Base64.)"""

import base64
import binascii
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
    by_rule = {}
    for job in jobs:
        by_rule.setdefault(job.rule, []).append(job)
    return [Step(rule, rule_jobs) for rule, rule_jobs in by_rule.items()]


def output_name(path, folder):
    """The output that an account belongs to; names that are too long are cut into folders @..."""
    code = "".join(part.lstrip("@") for part in path.relative_to(folder).parts)
    return base64.urlsafe_b64decode(code).decode()


def read_accounts(folder):
    accounts = {}
    for path in sorted(folder.rglob("*")):
        try:
            if path.is_file():
                name = output_name(path, folder)
                accounts[name] = json.loads(path.read_text(encoding="utf-8"))
        except (binascii.Error, ValueError):
            continue  # a file that Snakemake did not finish
    return accounts


class Accounts:
    def __init__(self, root):
        self.by_output = read_accounts(Path(root) / ".snakemake/metadata")

    def files_behind(self, recipe):
        """The results of a recipe and all files they were made from, directly or not."""
        waiting = [path for path in self.by_output if path.startswith(f"results/{recipe}/")]
        found = set(waiting)
        while waiting:
            inputs = self.by_output.get(waiting.pop(), {}).get("input") or []
            new = set(inputs) - found
            found |= new
            waiting.extend(new)
        return found

    def jobs(self, files):
        """The jobs that made the files, in the order in which they started. A job has an account
        for each of its outputs."""
        found = {}
        for path in files:
            account = self.by_output.get(path)
            if account and account.get("starttime"):
                started = account["starttime"]
                key = account["rule"], account["shellcmd"], *account["log"]
                seconds = max(account["endtime"] - started, 0)
                if key not in found or found[key].seconds < seconds:
                    command = " ".join((account["shellcmd"] or "").split())
                    found[key] = Job(account["rule"], command, started, seconds)
        return sorted(found.values(), key=lambda job: (job.started, job.rule))
