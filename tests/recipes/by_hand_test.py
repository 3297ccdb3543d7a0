"""results/NAME/commands.sh, run by hand in an empty folder, gives the same checksums."""

import os

from pytest import mark
from rupture import once
from rupture.commands.script import with_sources

import events
import figS1.commands
from conftest import BIN, ROOT, succeeds


def events_of_figure_2():
    for name in events.EVENTS.values():
        events.shown_event(name)


@mark.parametrize("ask, count", [(figS1.commands.states, 1), (events_of_figure_2, 6)])
def test_commands_by_hand_write_the_same_files(ask, count, folder, monkeypatch):
    for function in (events.shipped, events.shown_event, figS1.commands.states):
        function.cache_clear()
    store = once.use(store=folder / "store", dry_run=False).store
    with once.asked() as works:
        ask()
    script, expected = once.script_of(works, "a figure", ROOT), {}
    for number, work in enumerate(with_sources(works), 1):
        for name, checksum in store.result(work.own).get("checksums", {}).items():
            expected[f"{number:03}-{work.program}/{name}"] = checksum
    once.finish()
    (folder / "by hand").mkdir()
    (folder / "by hand/commands.sh").write_text(script)
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    monkeypatch.setenv("FILES", str(ROOT))
    succeeds("bash", "commands.sh", cwd=folder / "by hand")
    found = {
        name: succeeds("analyze", "checksum", folder / "by hand" / name).stdout.split()[0]
        for name in expected
    }
    assert len(found) == count
    assert found == expected
