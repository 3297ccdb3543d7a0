"""What Snakemake says on the terminal: one line per step, and everything about a failure. On a cluster,
where all steps that can begin wait in line at once, the line says what is going on (slurm/line.py).

Snakemake calls log_handler() with each of its messages. Each command also goes to the log file.
"""

import re
import sys
import time
from pathlib import Path

LOG = Path("build/log/recipes.log")
LAST_LINES = 30
ON_CLUSTER = any(argument.startswith("srun=") for argument in sys.argv)  # reproduce.sh
START = time.monotonic()
steps = {"started": 0, "total": "?"}


def log(text):
    LOG.parent.mkdir(parents=True, exist_ok=True)
    with LOG.open("a", encoding="utf-8") as file:
        print(time.strftime("%F %T"), text, file=file)


def complain(text):
    log(text)
    print(text, file=sys.stderr, flush=True)


def describe(message):
    """The rule's own sentence, or its name and wildcards."""
    if message["msg"]:
        return message["msg"].strip()
    wildcards = ", ".join(f"{name} {value}" for name, value in message.get("wildcards", {}).items())
    return message["name"] + (f" ({wildcards})" if wildcards else "")


def on_plan(message):
    """Snakemake's table of rules and how often each is to be run."""
    total = re.search(r"^total\s+(\d+)", message["msg"], re.MULTILINE)
    if total:
        steps["total"] = total[1]
        if ON_CLUSTER:
            print(f"{total[1]} steps", flush=True)


def on_start(message):
    steps["started"] += 1
    if message["output"] and not ON_CLUSTER:  # a rule without one only collects
        number = f"{steps['started']:{len(steps['total'])}}/{steps['total']}"
        print(f"[{time.monotonic() - START:4.0f} s] {number} {describe(message)}", flush=True)


def on_failure(message):
    complain(f"\nFailed: {describe(message)}")
    complain(f"  to make: {' '.join(message['output'])}")
    if message["shellcmd"]:
        complain(f"  command: {' '.join(message['shellcmd'].split())}")
    for path in map(Path, message["log"]):
        lines = path.read_text(errors="replace").splitlines() if path.exists() else []
        if lines:
            complain("\n    ".join([f"  {path} ends with:", *lines[-LAST_LINES:]]))


def log_handler(message):
    level = message["level"]
    if level == "job_info":
        on_start(message)
    elif level == "run_info":
        on_plan(message)
    elif level == "job_error":
        on_failure(message)
    elif level == "error" and not message["msg"].startswith("Exiting because a job"):
        complain(message["msg"])
    elif level == "shellcmd" and message["msg"]:
        log(" ".join(message["msg"].split()))
