"""Says what a sweep would compute."""

from sweeps.plural import plural
from sweeps.point_store import PointStore
from sweeps.sweep import read_sweep


def preview(plan, folder_of_tools, results, code):
    """`code`: fingerprint of the sources or programs."""
    sweep, store = read_sweep(plan), PointStore(results / "data/points", code)
    to_compute = [point for point in sweep.points if store.result(point) is None]
    there = len(sweep.points) - len(to_compute)
    count = plural(len(sweep.points), "point")
    print(f"{sweep.title}: {count}, {there} there, {len(to_compute)} to compute.")
    if to_compute:
        print("The first of these (its files are deleted afterwards):")
        for command in to_compute[0].commands.values():
            print(f"  {folder_of_tools}/{command}")
