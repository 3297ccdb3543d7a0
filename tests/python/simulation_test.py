"""rupture.Simulation: the same bits as restart, arrays, parameters, ends of a run, bad inputs."""

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

STEPS = 10_000
LAWS = ("reference", "simplified", "decaying", "distance")

need_simulation()


@pytest.fixture(scope="session", name="starts")
def starts_by_law(tmp_path_factory):
    """A checkpoint for each law, while a rupture passes."""
    folder = tmp_path_factory.mktemp("starts")
    for law in LAWS:
        law_of = {"junctions.law": law}
        rupture.run("load", output=folder / f"{law}.h5", config=SMALL, until=2e-4, set=law_of)
    return folder


@pytest.fixture(name="sim")
def in_new_folder(starts, folder):
    assert folder == Path.cwd()
    return rupture.Simulation(starts / "reference.h5")


def fails(sentence, call, *arguments, **options):
    with pytest.raises(rupture.Failure, match=sentence):
        call(*arguments, **options)


@pytest.mark.parametrize("law", LAWS)
def test_the_bits_are_those_of_restart(starts, folder, law):
    start, changed = starts / f"{law}.h5", {"driving.V": 0.5, "numerics.dt": "0.15 us"}
    dt = rupture.open(start).parameters["numerics.dt"]
    by_restart = rupture.run("restart", start, output="a.h5", for_=STEPS * dt)
    again = rupture.run("restart", "a.h5", output="b.h5", for_=100 * 1.5e-7, set=changed)
    sim = rupture.Simulation(start, threads=2)
    held, seen = sim["u_x"], []
    sim.step(3)
    sim.run(
        until=sim.time + (STEPS - 3) * dt, call=lambda now: seen.append(now.steps_done), every=999
    )
    assert sim.save("c.h5") == by_restart.checksum
    assert np.array_equal(held, rupture.open("c.h5")["u_x"])
    assert (len(seen), seen[0], seen[-1]) == (11, seen[-1] - STEPS + 3 + 999, sim.steps_done)
    sim.set(**changed)
    sim.step(100)
    assert sim.save("d.h5") == again.checksum == rupture.verify("d.h5")
    assert sim.parameters.items() >= rupture.open("d.h5").parameters.items()
    assert (sim.time, sim.F_T) == pytest.approx((rupture.open("d.h5").time, sim.F_T), abs=0)


def test_it_begins_as_load_does(folder):
    sim = rupture.Simulation.from_parameters(
        {"slider.Nx": 17, "slider.Nz": 9, "slider.H": "70mm", "driving.h": 0.00875}
    )
    same = rupture.run("load", output="same.h5", set=sim.parameters)
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


def test_what_is_written_into_arrays_counts(sim, starts):
    """As if a file had been changed so."""
    u_x, tau, pinned = sim["u_x"], sim["tau"], sim["pinned"].copy()
    before = tau.copy()
    u_x += 1e-7
    sim["junctions/repin_time"][-1] = sim.time + 1e-4
    assert sim["pinned"][-1] == 0 < pinned[-1] and not np.array_equal(tau, before)
    sim.save("changed.h5")
    sim.step(500)
    other = rupture.Simulation("changed.h5")
    other.step(500)
    assert sim.save("a.h5") == other.save("b.h5") != rupture.open("changed.h5").checksum
    assert u_x.shape == (9, 17) and np.array_equal(u_x, rupture.open("a.h5")["u_x"])
    for name in ("p", "tau", "pinned"):
        with pytest.raises(ValueError, match="read-only"):
            sim[name][0] = 1
    last = u_x.copy()
    del sim, other
    gc.collect()
    assert np.array_equal(u_x, last)  # its memory is still there
    sim = rupture.Simulation(starts / "reference.h5")
    sim["u_x"][2, 3] = np.nan
    fails("^/state/u_x holds nan at index 37 of .9..17.; only finite numbers are stored$", sim.step)
    sim["u_x"][2, 3] = 0.0
    sim.step()


def test_an_exception_of_the_callback_comes_out_and_the_run_goes_on(sim, starts):
    class Own(Exception):
        pass

    def call(now):
        if now.steps_done >= first + 30:
            raise Own("mine")

    first = sim.steps_done
    with pytest.raises(Own, match="^mine$"):
        sim.run(until=1, call=call, every=10)
    assert sim.steps_done == first + 30
    sim.run(stop=lambda now: now.steps_done >= first + 60, every=20)
    assert sim.steps_done == first + 70
    whole = rupture.Simulation(starts / "reference.h5")
    whole.step(70)
    assert whole.save("whole.h5") == sim.save("parts.h5")


def test_other_threads_run_and_are_refused_meanwhile(sim):
    worker = threading.Thread(target=sim.step, args=(300_000,))
    worker.start()
    wait_for(lambda: "another thread" in refusal(sim) or not worker.is_alive())
    assert worker.is_alive(), "it ended before another thread ran"
    worker.join()
    assert sim.steps_done > 300_000


def refusal(sim):
    try:
        return str(sim.time)
    except rupture.Failure as why:
        return str(why)


def test_ctrl_c_stops_between_steps(starts, folder):
    code = f"""if True:
        import rupture
        sim = rupture.Simulation({str(starts / "reference.h5")!r})
        try:
            print("begins", flush=True)
            sim.step(10**9)
        except KeyboardInterrupt:
            first = sim.steps_done
            sim.save("stopped.h5")
            sim.step()
            print(sim.steps_done - first)"""
    with subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout and process.stdout.readline() == "begins\n"
        time.sleep(0.3)  # within its step
        process.send_signal(signal.SIGINT)
        assert process.stdout.read() == "1\n"
    rupture.verify(folder / "stopped.h5")


def test_bad_inputs_are_one_sentence_and_lose_nothing(sim, starts):
    start, t = starts / "reference.h5", sim.time
    fails(
        "slider.Nx cannot change in a restart: the checkpoint has 17; start",
        sim.set,
        **{"slider.Nx": 9},
    )
    fails("^unknown parameter 'driving.W': did you mean 'driving.K'.$", sim.set, **{"driving.W": 9})
    fails("run needs an end: give until, a time in s, or stop, a function$", sim.run)
    fails("^until must be a time in s .got '1 ms'.$", sim.run, "1 ms")
    fails("^until 1e-06 is before the simulation's time 0.0002 s$", sim.run, 1e-6)
    fails("^stop is true already, at 0.0002 s", sim.run, stop=lambda now: True)
    fails("^steps must be a whole number from 0 to .* .got -1.$", sim.step, -1)
    fails("^every must be a whole number from 1 to .* .got 0.5.$", sim.run, 1, every=0.5)
    fails("the simulation has no tou; it has u_x, u_z", lambda: sim["tou"])
    fails("nowhere.h5", rupture.Simulation, "nowhere.h5")
    fails("set must be a dict", rupture.Simulation.from_parameters, 3)
    Path("mine.h5").write_text("mine")
    fails("^mine.h5 exists; give force=True to replace it$", sim.save, "mine.h5")
    fails("reference.h5 is what this simulation began with", sim.save, start, force=True)
    Path("link.h5").symlink_to("mine.h5")
    fails("link.h5", sim.save, "link.h5")
    assert Path("mine.h5").read_text() == "mine"
    assert sim.time == t and sim.save("mine.h5", force=True) == rupture.open(start).checksum


def test_an_alarm_ends_a_run(sim):
    """As that of load and restart."""
    sim["v_x"][4, 8] += 1e3
    fails("^the energy account from t = 0.0002 s to 0.001 s is off by", sim.run, sim.time + 1e-3)


def test_without_the_module_the_rest_works(folder):
    code = "import rupture; print(rupture.open); rupture.Simulation('a.h5')"
    words = {**os.environ, "RUPTURE_BIN": str(folder)}
    done = subprocess.run([sys.executable, "-c", code], env=words, capture_output=True, text=True)
    assert done.stdout.startswith("<function open_file")
    last = done.stderr.splitlines()[-1]
    assert "rupture.Simulation is not built for Python 3." in last
    assert "install pybind11-dev" in last
