"""The rupture events of a load, measured in many ways: measure_events.py RECORD

Prints {convention: events as `analyze events --json` lists them} (events/conventions.py)."""

from events.conventions import CONVENTIONS, each_way


def main(record):
    return {
        name: report["events"] for name, report in each_way("events", record, CONVENTIONS).items()
    }
