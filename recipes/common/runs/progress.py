"""Snakemake's messages on the terminal: one line per step, and everything about a failure.

Snakemake calls log_handler() with each of its messages. Each command also goes to the log file, and
what was done, by which command and in which time, to results/jobs.jsonl, for the report.
"""

import json
import logging
import os
import re
import sys
import time
from pathlib import Path

from runs.written import append_to, note

LOG = Path("build/log/recipes.log")
RESULTS = Path("results")
JOBS = RESULTS / "jobs.jsonl"
LAST_LINES = 30
COLLECTING = ("all", "refine", "start")  # rules that make nothing themselves
START = time.monotonic()
steps: dict = {"started": 0, "total": "?"}
jobs = {}  # number: what is known of a job that runs

# Snakemake's own messages. Its option --quiet would also keep from us when a job has ended.
logging.getLogger("snakemake.logging").addFilter(lambda record: False)


def log(text):
    LOG.parent.mkdir(parents=True, exist_ok=True)
    with LOG.open("a", encoding="utf-8") as file:
        print(time.strftime("%F %T"), text, file=file)


def show(text):
    """A reader who has gone, as of `| head`, or a full disk does not stop the run."""
    try:
        print(text, flush=True)
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(text):
    log(text)
    print(text, file=sys.stderr, flush=True)


def on_plan(message):
    """Snakemake's table of rules and how often each is to be run."""
    counts = dict(re.findall(r"^(\w+)\s+(\d+)", message["msg"], re.MULTILINE))
    if "total" in counts:
        collecting = sum(int(counts.get(name, 0)) for name in COLLECTING)
        steps["total"] = str(int(counts["total"]) - collecting)


def on_start(message):
    description = (message["msg"] or message["name"]).strip()
    jobs[message["jobid"]] = {
        "description": description,
        "rule": message["name"],
        "started": time.time(),
        "command": "",
        **{name: [str(path) for path in message[name]] for name in ("input", "output")},
    }
    records = [f"{path}.part" for path in message["output"] if str(path).endswith(".h5")]
    note(RESULTS, JOBS, *message["output"], *message["log"], *records)
    if message["name"] not in COLLECTING:
        steps["started"] += 1
        number = f"{steps['started']:{len(steps['total'])}}/{steps['total']}"
        show(f"[{time.monotonic() - START:4.0f} s] {number} {description}")


def on_command(message):
    """It follows the start of its job."""
    text = " ".join(message["msg"].split())
    jobs[next(reversed(jobs))]["command"] = text
    log(text)


def on_end(message):
    job = jobs.pop(message["jobid"])
    if job["output"]:
        job["seconds"] = time.time() - job["started"]
        JOBS.parent.mkdir(exist_ok=True)
        with append_to(JOBS) as file:
            print(json.dumps(job), file=file)


def on_failure(message):
    complain(f"\nFailed: {jobs.pop(message['jobid'])['description']}")
    first, *others = message["output"]
    complain(f"  to make: {first}" + (f" and {len(others)} more" if others else ""))
    if message["shellcmd"]:
        command = " ".join(message["shellcmd"].split())
        rest = f" ... (all of it: {LOG})" if len(command) > 200 else ""
        complain(f"  command: {command[:200]}{rest}")
    for path in map(Path, message["log"]):
        lines = path.read_text(errors="replace").splitlines() if path.exists() else []
        if lines:
            complain("\n    ".join([f"  {path} ends with:", *lines[-LAST_LINES:]]))


def log_handler(message):
    level = message["level"]
    if level == "job_info":
        on_start(message)
    elif level == "job_finished":
        on_end(message)
    elif level == "run_info":
        on_plan(message)
    elif level == "job_error":
        on_failure(message)
    elif level == "error" and not message["msg"].startswith("Exiting because a job"):
        complain(message["msg"])
    elif level == "shellcmd" and message["msg"]:
        on_command(message)
    elif level == "info" and message["msg"].startswith("Trying to restart"):
        steps["started"] -= 1
        complain("Trying again.")
