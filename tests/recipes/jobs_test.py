"""The commands behind results, as the store has them."""

from conftest import run as by_hand
from report.jobs import builds_of, files_of, jobs_of, read_jobs, write_jobs
from rupture import once
from rupture.once import asked, measured, run


def name_of(path):
    return path.name


def test_they_are_what_was_asked_for_and_what_that_came_from(folder):
    once.use(store=folder / "store", cores=1, dry_run=False)
    by_hand("prepare", "--tau-bar", "0.2", "-o", "own.h5")
    with asked() as works:
        start = run("prepare --tau-bar 0.3 -o start.h5")["start.h5"]
        run("prepare --tau-bar 0.4 -o unneeded.h5")
        run(f"analyze stress {start}")
        run(f"analyze show {folder}/own.h5")
        measured(name_of, start)
    jobs = [*jobs_of(works)]
    write_jobs(folder, jobs)
    once.finish()
    made, stress, show, name = read_jobs(folder)
    assert [*map(str, jobs)] == [*map(str, (made, stress, show, name))]
    assert made["command"] == "rupture prepare --tau-bar 0.3 -o start.h5"
    by_hand(*made["command"].split()[1:])
    checksum = by_hand("analyze", "checksum", "start.h5").stdout.split()[0]
    assert files_of(jobs) == [(made["id"], "start.h5", checksum)]
    assert stress["inputs"] == name["inputs"] == {"start.h5": f"{made['id']}/start.h5"}
    assert show["inputs"]["own.h5"].endswith(f"{folder.name}/own.h5")
    assert [count for _, count in builds_of(jobs)] == [3]
    assert sum(one["seconds"] for one in jobs) > 0
