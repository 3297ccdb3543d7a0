#!/usr/bin/env python3
"""Measures the time per step and its parts with every instruction set of this processor, the
equilibrium solve, checkpoints and records, larger sliders, more threads, and the bulk in LAMMPS if
that is installed. Prints tables with the targets beside the values and writes everything in the
JSON format of Google Benchmark. Takes about 3 minutes; leave the machine alone meanwhile.
benchmarks/README.md explains the rows. Environment: LMP, the LAMMPS program (default: lmp)."""

import argparse
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
INSTRUCTION_SETS = ("sse2", "avx2", "avx512", "baseline", "neon")  # narrowest first
STEPS = "step/|bulk/|junctions/"
VARIANTS = ("springs", "drag", "damping")  # of lammps/bulk.in

STEP_TARGETS = {"sse2": 25.0, "avx2": 8.0, "avx512": 5.0}  # [us]
TARGETS = {"once/equilibrium_solve": 50.0, "once/checkpoint_write": 5.0}  # [ms]
RECORD_TARGET = 10.0  # [% of the time of a run without]
GROWTH_IN_CACHE, GROWTH_BEYOND = 1.2, 2.0  # time per block and step, against the reference size
SPEEDUP_TARGET, SPEEDUP_FROM = 1.8, 225 * 121  # on 2 threads; from this many blocks on

BLOCKS = 57 * 31


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", metavar="FILE", type=Path, default=ROOT / "build/benchmarks.json")
    text = "use DIR/bench instead of building the preset release"
    parser.add_argument("--bin", metavar="DIR", type=Path, help=text)
    text = "one round, shorter, without the largest sizes: about 40 s, for a first impression"
    parser.add_argument("--quick", action="store_true", help=text)
    return parser.parse_args()


# --- measuring ------------------------------------------------------------------------------------


def output_of(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        sys.exit(f"{done.stdout}{done.stderr}run.py: this failed: {' '.join(map(str, command))}")
    return done.stdout


def built():
    print("Building ...", file=sys.stderr)
    output_of("cmake", "--preset", "release", cwd=ROOT)
    output_of("cmake", "--build", "--preset", "release", "--target", "bench", cwd=ROOT)
    return ROOT / "build/release/bin"


def runs_with(bench, isa):
    command = [bench, "--benchmark_list_tests"]
    environment = os.environ | {"RUPTURE_ISA": isa}
    return not subprocess.run(command, env=environment, capture_output=True, check=False).returncode


def measure(bench, isa, rows, scratch, *options):
    """Google Benchmark's results for these rows; their names begin with the instruction set."""
    environment = os.environ | {"RUPTURE_ISA": isa, "TMPDIR": str(scratch)}
    command = bench, "--benchmark_format=json", f"--benchmark_filter=^({rows})", *options
    said = json.loads(output_of(*command, env=environment))
    for entry in said["benchmarks"]:
        if entry.get("error_occurred"):
            sys.exit(f"run.py: {entry['name']} with {isa}: {entry['error_message']}")
        entry["name"] = f"{isa}/{'/'.join(entry['name'].split('/')[:2])}"
    return said


def lammps(lmp, variant, steps, scratch):
    """Microseconds of processor time per step of this bulk."""
    environment = os.environ | {"TMPDIR": str(scratch), "OMP_NUM_THREADS": "1"}
    environment["OMPI_MCA_ess_singleton_isolated"] = "1"  # no helper daemon
    variables = {"bulk": HERE / "lammps/bulk.in", "variant": variant, "steps": str(steps)}
    words = [word for item in variables.items() for word in ("-var", *item)]
    command = lmp, "-log", "none", "-nocite", "-in", HERE / "lammps/time.in", *words
    said = output_of(*command, cwd=scratch, env=environment, stdin=subprocess.DEVNULL)
    seconds, steps = re.findall(r"^Loop time of (\S+) .* for (\d+) steps", said, re.M)[-1]
    share = re.findall(r"([\d.]+)% CPU use", said)[-1]
    return 1e6 * float(seconds) / int(steps) * float(share) / 100


def measure_lammps(lmp, seconds, scratch):
    """LAMMPS's results in the form of Google Benchmark."""
    for variant in VARIANTS:
        steps = 1000 * int(seconds * 1e3 / lammps(lmp, variant, 2000, scratch) + 1)
        for us in (lammps(lmp, variant, steps, scratch) for _ in range(2)):
            entry = {"run_type": "iteration", "iterations": steps, "time_unit": "us"}
            yield {"name": f"lammps/{variant}", **entry, "real_time": us, "cpu_time": us}


def measured(options, bench, scratch):
    """Everything in turn, several times, so that a busy spell does not affect only one row.
    The scratch folder is beside the result: files must be on a disk, and /tmp may be in memory."""
    available = [isa for isa in INSTRUCTION_SETS if runs_with(bench, isa)]
    lmp = shutil.which(os.environ.get("LMP", "lmp"))
    if not lmp:
        print("LAMMPS is not installed (Debian package: lammps): not measured.", file=sys.stderr)
    twice = f"--benchmark_min_time={0.05 if options.quick else 0.1}", "--benchmark_repetitions=2"
    total: dict = {"benchmarks": []}
    for number in range(1 if options.quick else 3):
        print(f"Round {number + 1} ...", file=sys.stderr)
        parts = [measure(bench, isa, STEPS, scratch, *twice) for isa in available]
        parts.append(measure(bench, available[-1], "once/|record/", scratch, *twice))
        parts.append(measure(bench, available[-1], "size/0" if options.quick else "size/", scratch))
        if lmp:
            seconds = 0.5 if options.quick else 1.0
            parts.append({"benchmarks": [*measure_lammps(lmp, seconds, scratch)]})
        for part in parts:
            entries = [e for e in part["benchmarks"] if e["run_type"] == "iteration"]
            total = total | part | {"benchmarks": total["benchmarks"] + entries}
    return total, available


# --- tables ---------------------------------------------------------------------------------------


def print_table(title, *rows):
    """First column to the left, the others to the right."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    print(f"\n{title}")
    for first, *cells in rows:
        right = (f"{cell:>{width}}" for cell, width in zip(cells, widths[1:]))
        print(f"  {first:<{widths[0]}}", *right, sep="  ")


def against(value, target):
    verdict = "" if target is None else " ok" if value <= target else f" > {target:g}"
    return f"{value:.2f}{verdict}"


class Rows:
    """The measurements: for each row one value per repetition, of which times show the best."""

    def __init__(self, entries):
        self.entries = entries

    def values(self, name, key="items_per_second"):
        return [entry[key] for entry in self.entries if entry["name"] == name]

    def time(self, name, scale):
        return scale / max(self.values(name))

    def of(self, isa, *groups):
        """Names of the rows of these groups, without the instruction set, in the order measured."""
        names = dict.fromkeys(entry["name"].removeprefix(f"{isa}/") for entry in self.entries)
        return [name for name in names if name.split("/")[0] in groups]


def steps_table(rows, available):
    yield ["", *available]
    for row in rows.of(available[0], "step", "bulk", "junctions"):
        goals = STEP_TARGETS if row in ("step/loading", "step/sliding") else {}
        times = [(isa, rows.time(f"{isa}/{row}", 1e6)) for isa in available]
        yield [row, *(against(time, goals.get(isa)) for isa, time in times)]
    bulk = [rows.time(f"{isa}/bulk/step", 1e6) for isa in available]
    for name in rows.of("", "lammps"):
        ratios = (min(rows.values(name, "cpu_time")) / time for time in bulk)
        yield [f"{name} / bulk/step", *(f"{ratio:.1f}" for ratio in ratios)]


def once_table(rows, isa):
    for row in rows.of(isa, "once"):
        yield [f"{row} [ms]", against(rows.time(f"{isa}/{row}", 1e3), TARGETS.get(row))]
    for row in rows.of(isa, "record"):
        for key, text in (("cost_running", "before the end"), ("cost", "with finishing the file")):
            value = 100 * median(rows.values(f"{isa}/{row}", key))
            target = None if (row, key) == ("record/fields", "cost") else RECORD_TARGET
            yield [f"{row}, {text} [%]", against(value, target)]


def sizes_table(rows, isa, cache):
    """One row per size: for each number of threads the ratio of the best times and of paired
    ones."""
    names = [f"{isa}/{size}" for size in sorted(rows.of(isa, "size"))]
    first = next(entry for entry in rows.entries if entry["name"] == names[0])
    threads = sorted(int(key[3:]) for key in first if key.startswith("us_"))[1:]
    shared = (f"{n} threads, paired" for n in threads)
    yield ["blocks", "us/step", "ns/block", "growth", *shared]
    for name in names:
        Nx, Nz = (int(rows.values(name, key)[0]) for key in ("Nx", "Nz"))
        alone = min(rows.values(name, "us_1"))
        growth = alone / (Nx * Nz) / (min(rows.values(names[0], "us_1")) / BLOCKS)
        target = GROWTH_IN_CACHE if 32 * Nx * Nz <= cache else GROWTH_BEYOND
        cells = [f"{alone:.1f}", f"{1e3 * alone / Nx / Nz:.2f}", against(growth, target)]
        for n in threads:
            speedup = alone / min(rows.values(name, f"us_{n}"))
            missed = n == 2 and Nx * Nz >= SPEEDUP_FROM and speedup < SPEEDUP_TARGET
            paired = median(rows.values(name, f"paired_{n}"))
            cells.append(f"{speedup:.2f}{f' < {SPEEDUP_TARGET}' if missed else ''}, {paired:.2f}")
        yield [f"{Nx} x {Nz}", *cells]


def main():
    options = arguments()
    # bench is aborted where RUPTURE_ISA names what this processor lacks.
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    bench = (options.bin or built()).resolve() / "bench"
    options.o.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=options.o.parent) as scratch:
        total, available = measured(options, bench, scratch)
    options.o.write_text(json.dumps(total, indent=1) + "\n", encoding="utf-8")
    rows, widest, context = Rows(total["benchmarks"]), available[-1], total["context"]
    print(f"{context['build']}, {context['date']}, load {context['load_avg'][0]:.1f}")
    title = "Time per step and of its parts, 57 x 31 blocks [us]"
    print_table(title, *steps_table(rows, available))
    print_table(f"Once in a while, 57 x 31 blocks, {widest}", *once_table(rows, widest))
    cache = max((cache["size"] for cache in context.get("caches", [])), default=0)
    title = f"Larger sliders, {widest}; the last cache has {cache / 2**20:.0f} MiB"
    print_table(title, *sizes_table(rows, widest, cache))
    print(f"\nEverything is in {options.o}")


if __name__ == "__main__":
    main()
