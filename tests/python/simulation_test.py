"""rupture.Simulation: the bits of restart, arrays, ends of a run, what it refuses."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import rupture
from conftest import SMALL, need_simulation, run, wait_for

need_simulation()
STEPS = 10_000
LAWS = ("reference", "simplified", "decaying", "distance")


@pytest.fixture(scope="session", name="starts")
def starts_by_law(tmp_path_factory):
    """A checkpoint for each law, while a rupture passes."""
    folder = tmp_path_factory.mktemp("starts")
    for law in LAWS:
        of_law = {"junctions.law": law}
        rupture.run("load", output=folder / f"{law}.h5", config=SMALL, until=2e-4, set=of_law)
    return folder


@pytest.fixture(name="sim")
def in_new_folder(starts, folder):
    assert folder == Path.cwd()
    return rupture.Simulation(starts / "reference.h5")


def fails(sentence, call, *arguments, **options):
    with pytest.raises(rupture.Failure, match=sentence) as raised:
        call(*arguments, **options)
    return str(raised.value)


@pytest.mark.parametrize("law", LAWS)
def test_the_bits_are_those_of_restart(starts, folder, law):
    changed = {"driving.V": 0.5, "numerics.dt": "0.15 us"}
    sim, seen = rupture.Simulation(starts / f"{law}.h5", threads=2), []
    u_x, end = sim["u_x"], sim.time + STEPS * sim.parameters["numerics.dt"]
    sim.step(3)
    sim.run(until=end, call=lambda now: seen.append(now.steps_done), every=999)
    assert seen[0] == seen[-1] - STEPS + 3 + 999 and len(seen) == 11
    same = rupture.run("restart", starts / f"{law}.h5", output="same.h5", for_=2e-7 * STEPS)
    assert sim.save("own.h5") == same.checksum
    assert np.array_equal(u_x, rupture.open("own.h5")["u_x"])
    sim.set(changed)
    sim.step(100)
    same = rupture.run("restart", "same.h5", output="then.h5", for_=1.5e-5, set=changed)
    assert sim.save("changed.h5") == same.checksum == rupture.verify("changed.h5")
    assert sim.parameters.items() >= same.checkpoint.parameters.items()
    assert sim.time == same.checkpoint.time


def test_it_begins_as_load_does(folder):
    small = {"slider.Nx": 17, "slider.Nz": 9, "slider.H": "70mm", "driving.h": 0.00875}
    patch = {"junctions.mu_s": "0.5 from 70mm to 84mm", "junctions.f_new": "f_slip from 0 to 9mm"}
    sim = rupture.Simulation.from_parameters(small | patch)
    same = rupture.run("load", output="same.h5", set=sim.parameters)
    assert same.checkpoint.parameters["junctions.f_new"] == sim.parameters["junctions.f_new"]
    sim.save("own.h5")
    [own] = rupture.open("own.h5").provenance
    assert same.checksum == own["parent_checksum"] == rupture.open("own.h5").checksum


def test_where_a_file_comes_from(sim, starts):
    sim.step()
    sim.save("saved.h5")
    rupture.run("restart", "saved.h5", output="later.h5", for_=1e-5)
    _, own, _ = rupture.open("later.h5").provenance
    assert own["tool"] == "python" and "pytest" in own["command_line"]
    assert own["parent_checksum"] == rupture.open(starts / "reference.h5").checksum
    told = run("analyze", "lineage", "later.h5", "--commands")
    says = "step 1 (python) has no command, because it is no program of rupture: give the file"
    assert told.returncode == 1 and says in told.stderr
    assert run("analyze", "lineage", "later.h5", "--commands", "--from", "saved.h5").returncode == 0


def test_what_is_written_into_arrays_counts_as_in_a_file(sim):
    u_x, before = sim["u_x"], sim["tau"].copy()
    u_x += 1e-7
    sim["junctions/repin_time"][-1] = sim.time + 1e-4
    assert sim["pinned"][-1] == 0 and not np.array_equal(sim["tau"], before)
    sim.save("changed.h5")
    other = rupture.Simulation("changed.h5")
    for one in (sim, other):
        one.step(500)
    assert sim.save("a.h5") == other.save("b.h5") != rupture.open("changed.h5").checksum
    for name in ("p", "tau", "pinned"):
        with pytest.raises(ValueError, match="read-only"):
            sim[name][0] = 1
    right, u_x[2, 3] = u_x[2, 3], np.nan
    fails("^/state/u_x holds nan at index 37 of .9..17.; only finite numbers", sim.step)
    u_x[2, 3] = right
    sim.step()
    last = u_x.copy()
    del sim, other, one
    gc.collect()
    assert np.array_equal(u_x, last)  # its memory is still there


def test_exceptions_of_a_callback_come_out_and_the_run_goes_on(sim, starts):
    def call(now):
        if now.steps_done == first + 30:
            raise ZeroDivisionError("mine")

    first = sim.steps_done
    with pytest.raises(ZeroDivisionError, match="^mine$"):
        sim.run(until=1, call=call, every=10)
    sim.run(lambda now: now.steps_done >= first + 60, every=20)
    assert sim.steps_done == first + 70
    whole = rupture.Simulation(starts / "reference.h5")
    whole.step(70)
    assert whole.save("whole.h5") == sim.save("parts.h5")


def test_other_threads_run_and_are_refused_meanwhile(sim):
    def is_refused():
        try:
            return sim.time < 0
        except rupture.Failure as why:
            return "another thread steps this simulation" in str(why)

    worker = threading.Thread(target=sim.step, args=(300_000,))
    worker.start()
    wait_for(is_refused)
    worker.join()
    assert sim.steps_done > 300_000


def test_ctrl_c_stops_between_steps(sim, starts):
    sim.save("start.h5")
    code = """if True:
        import rupture
        sim = rupture.Simulation("start.h5")
        try:
            print("begins", flush=True)
            sim.step(10**9)
        except KeyboardInterrupt:
            sim.step()
            print(sim.save("stopped.h5"))"""
    words = [sys.executable, "-c", code]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout and process.stdout.readline() == "begins\n"
        time.sleep(0.3)  # within its step
        process.send_signal(signal.SIGINT)
        assert process.stdout.read().strip() == rupture.verify("stopped.h5")
    sim.step(rupture.open("stopped.h5")["step"] - sim.steps_done)
    assert sim.save("same.h5") == rupture.open("stopped.h5").checksum


def test_what_cannot_be_is_one_sentence_and_nothing_is_lost(sim, starts):
    start, t = starts / "reference.h5", sim.time
    Path("mine.h5").write_text("mine")
    Path("link.h5").symlink_to("mine.h5")
    for sentence, call, *arguments in (
        ("^slider.Nx cannot change in a restart: .* 17; start", sim.set, {"slider.Nx": 9}),
        ("^unknown parameter 'driving.W': did you mean 'driving", sim.set, {"driving.W": 9}),
        ("^until must be a time in s, a condition or a function .got None.$", sim.run, None),
        ("^'1 ms' compares nothing by < <= > or >=: write", sim.run, "1 ms"),
        ("^until is true already, at 0.0002 s", sim.run, "F_T > 0 or t > 1s"),
        ("^until 1e-06 is before the simulation's time 0.0002 s$", sim.run, 1e-6),
        ("^steps must be a whole number from 0 to .* .got -1.$", sim.step, -1),
        ("^steps must be a whole number from 0 to .* .got 0.5.$", sim.step, 0.5),
        ("^the simulation has no tou; it has u_x, u_z, ", sim.__getitem__, "tou"),
        ("^nowhere.h5 does not exist; give", rupture.Simulation, "nowhere.h5"),
        ("^set must be a dict", rupture.Simulation.from_parameters, 3),
        ("^mine.h5 exists; give force=True to replace it$", sim.save, "mine.h5"),
        ("^link.h5 exists; give force=True to replace it$", sim.save, "link.h5"),
    ):
        assert "\n" not in fails(sentence, call, *arguments)
    fails("reference.h5 is what this simulation began with", sim.save, start, force=True)
    fails("^threads must be .* from 1 to 1024 .got 0.$", rupture.Simulation, start, threads=0)
    assert Path("mine.h5").read_text() == "mine"
    assert sim.time == t and sim.save("mine.h5", force=True) == rupture.open(start).checksum
    sim["v_x"][4, 8] += 1e3
    sim.save("kicked.h5")
    fails("^the energy account from t = 0.0002 s to 0.001 s is off by", sim.run, 1.2e-3)
    options = {"output": "b.h5", "for_": 1e-3}
    fails("this state is in b.alarm.h5$", rupture.run, "restart", "kicked.h5", **options)
    fails("^an alarm stopped a run in the state of b.alarm", rupture.Simulation, "b.alarm.h5")


def test_without_the_module_the_rest_works(folder):
    code = "import rupture; print(rupture.open); rupture.Simulation('a.h5')"
    environment = os.environ | {"RUPTURE_BIN": str(folder)}
    done = run(sys.executable, "-c", code, env=environment)
    assert done.stdout.startswith("<function open_file")
    assert "rupture.Simulation is not built for Python 3." in done.stderr.splitlines()[-1]
