"""The rupture events of a load, measured in many ways: measure_events.py RECORD [SETTING]

Prints {convention: events as `analyze events --json` lists them} (events/conventions.py); for the
claims on fronts of a SETTING {combination of conventions: {claim: held}} (events/product.py)."""

from events.conventions import WAYS, each_way
from events.product import claims_held, combinations


def main(record, setting=None):
    found = each_way("events", record, combinations() if setting else WAYS)
    events = {name: report["events"] for name, report in found.items()}
    return {n: claims_held(setting, of) for n, of in events.items()} if setting else events
