#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Runs the fast-slow events of a load with the simplified law without slow slip:

    without_slow_slip.py PROGRAMS RUN CHECKPOINT_EVERY OPTIONS_OF_RECORDS

RUN is results/data/ensemble/simplified-03, say. An event counts if it is fast-slow under any
convention. Prints, by the events' numbers, {"t_start", "conventions": {convention: front}} with the
front without slow slip, null where nothing ruptures.
"""

import json
import sys
from pathlib import Path

from workshop import Workshop, without_lines

from data.scratch import scratch
from events.choose_events import start
from events.conventions import WAYS
from events.fronts import is_fast_slow

WITHOUT = ["--set", "junctions.v_slow=0"]
# Ends once nothing has broken for 12 ms, so that a record holds one event only.
LASTING = ["--until-quiet", "0.012", "--for", "0.05"]


def measure(workshop, run, event, checkpoint_every):
    before = start(event, checkpoint_every)
    workshop.run("restart", f"{run}-t{before['from']}.h5", "start", "--until", before["until"])
    workshop.recorded(workshop.path("start"), "without", *WITHOUT, *LASTING)
    fronts = {name: workshop.front("without", name) for name in WAYS}
    return {
        "t_start": event["t_start"],
        "conventions": {name: without_lines(front) for name, front in fronts.items()},
    }


def main(programs, run, checkpoint_every, record_options):
    lists = json.loads(Path(f"{run}-events.json").read_text(encoding="utf-8")).values()
    chosen = {event["number"]: event for events in lists for event in filter(is_fast_slow, events)}
    with scratch(Path(f"{run}-scratch")) as folder:
        workshop = Workshop(programs, folder, record_options)
        found = {
            number: measure(workshop, run, event, float(checkpoint_every))
            for number, event in sorted(chosen.items())
        }
    print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
