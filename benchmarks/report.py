#!/usr/bin/env python3
"""Merges the measurements of run.sh, prints them as tables and writes them as one JSON file:
report.py OUT.json MEASURED.json... --lammps LINES"""

import json
import os
import platform
import re
import sys
from pathlib import Path
from statistics import median

# Required speeds; every target is met by a value at most as large, but for speedups.
STEP_TARGETS = {"sse2": 25.0, "avx2": 8.0, "avx512": 5.0}  # [us]
ONCE_TARGETS = {"equilibrium_solve": 50.0, "checkpoint_write": 5.0}  # [ms]
RECORD_TARGET = 10.0  # [% of the time of a run without]
GROWTH_IN_CACHE, GROWTH_BEYOND = 1.2, 2.0  # time per block and step, against the reference size
SPEEDUP_TARGET, SPEEDUP_FROM = 1.8, 225 * 121  # on 2 threads; from this many blocks on

BLOCKS = 57 * 31

# Additions, subtractions and multiplications per block and step in src/forces/kernels, for a block
# with all neighbours at small strain; README.md derives them.
FLOPS = {
    "springs: differences of u (4 springs, 2 components)": 8,
    "springs: strain (4 along the axes, 6 across, twice each)": 20,
    "springs: tension (13 each)": 52,
    "springs: force (3 along the axes, 4 across, twice each)": 14,
    "springs: sums of forces": 14,
    "damping: sums over 3 rows and 3 columns, eta (...)": 15,
    "net force, both half kicks, drift": 12,
    "power of the damping": 4,
}
FLOPS_PER_BLOCK = sum(FLOPS.values())
BYTES_PER_BLOCK = 64  # u and v, two components each, read and written


def fail(message):
    sys.exit(f"report.py: {message}")


# --- reading --------------------------------------------------------------------------------------


class Measurements:
    """Everything that was measured, by row and instruction set."""

    def __init__(self, paths):
        self.entries = {}  # (row, instruction set) -> entries of Google Benchmark
        self.context = {}
        self.load = 0.0  # at most, programs ready to run, averaged over a minute
        self.instruction_sets = []  # narrowest first, as run.sh measures them
        for path in paths:
            with open(path, encoding="utf-8") as file:
                content = json.load(file)
            self.context = content["context"]
            self.load = max(self.load, self.context["load_avg"][0])
            isa = self.context["instruction_set"]
            for entry in content["benchmarks"]:
                if entry.get("run_type") == "aggregate":
                    continue
                row = "/".join(entry["name"].split("/")[:2])
                if entry.get("error_occurred"):
                    fail(f"{row} with {isa}: {entry['error_message']}")
                self.entries.setdefault((row, isa), []).append(entry)
        order = ["sse2", "avx2", "avx512", "baseline", "neon"]
        self.instruction_sets = sorted({isa for _, isa in self.entries}, key=order.index)
        self.widest = self.instruction_sets[-1]

    def rows(self, group):
        """The rows of a group in the order in which they were measured first."""
        return list(dict.fromkeys(row for row, _ in self.entries if row.startswith(group + "/")))

    def values(self, row, name, isa=None):
        """One value per repetition."""
        return [entry[name] for entry in self.entries.get((row, isa or self.widest), [])]

    def times(self, row, scale, isa=None):
        """Time of one item (step, file, ...) per repetition."""
        return [scale / rate for rate in self.values(row, "items_per_second", isa)]


class Results:
    """The content of the JSON file."""

    def __init__(self):
        self.list = []

    def add(self, name, value, unit, statistic, samples=None, at_most=None, at_least=None, **more):
        result = {"name": name, **more, "value": value, "unit": unit, "statistic": statistic}
        if at_most is not None:
            result.update(target=f"<= {at_most:g}", met=value <= at_most)
        if at_least is not None:
            result.update(target=f">= {at_least:g}", met=value >= at_least)
        if samples:
            result["samples"] = [round(sample, 6) for sample in samples]
        self.list.append(result)
        return result


def met(*results):
    return " ".join({None: "-", True: "yes", False: "NO"}[r.get("met")] for r in results)


def read_lammps(path):
    """Best time per step by variant, over all lines."""
    best, version = {}, None
    for line in Path(path).read_text(encoding="utf-8").splitlines():
        entry = json.loads(line)
        best.setdefault(entry["name"], []).append(entry["us_per_step"])
        version = entry["version"]
    return best, version


def machine():
    cpu = platform.machine()
    try:
        cpuinfo = Path("/proc/cpuinfo").read_text(encoding="utf-8")
        cpu = re.search(r"^model name\s*:\s*(.*)$", cpuinfo, re.MULTILINE)[1]
    except (OSError, TypeError):
        pass
    return {"processor": cpu, "processors": os.cpu_count(), "system": platform.platform()}


# --- the tables -----------------------------------------------------------------------------------


def print_table(title, heads, rows):
    """First column to the left, the others to the right."""
    table = [[str(cell) for cell in row] for row in [heads, *rows]]
    widths = [max(len(row[column]) for row in table) for column in range(len(heads))]
    print(f"\n{title}")
    for row in table:
        cells = [
            f"{cell:{'<' if c == 0 else '>'}{width}}"
            for c, (cell, width) in enumerate(zip(row, widths))
        ]
        print("  " + "  ".join(cells).rstrip())


def steps(measured, results):
    """Steps, bulk and junctions by instruction set."""
    table = []
    for row in [*measured.rows("step"), *measured.rows("bulk"), *measured.rows("junctions")]:
        found = []
        for isa in measured.instruction_sets:
            samples = measured.times(row, 1e6, isa)
            target = STEP_TARGETS.get(isa) if row in ("step/loading", "step/sliding") else None
            found.append(
                results.add(
                    row, min(samples), "us", "best", samples, at_most=target, instruction_set=isa
                )
            )
        targets = " / ".join(f"{STEP_TARGETS.get(isa, 0):g}" for isa in measured.instruction_sets)
        has_target = any("target" in result for result in found)
        table.append(
            [
                row,
                *(f"{result['value']:.2f}" for result in found),
                *(("<= " + targets, met(*found)) if has_target else ()),
            ]
        )
    return [row + [""] * (len(measured.instruction_sets) + 3 - len(row)) for row in table]


def roofline(measured, results):
    """The fraction of the peak that the bulk reaches."""
    flops = FLOPS_PER_BLOCK * BLOCKS * 1e-3  # [thousands]: per microsecond, these are GFLOP/s
    peaks, shares = [], []
    for isa in measured.instruction_sets:
        samples = [
            rate * 1e-9
            for rate in measured.values("peak/sums_and_products", "items_per_second", isa)
        ]
        peaks.append(
            results.add(
                "peak/sums_and_products",
                max(samples),
                "GFLOP/s",
                "best",
                samples,
                instruction_set=isa,
            )
        )
        reached = flops / min(measured.times("bulk/step", 1e6, isa))
        results.add("bulk/rate", reached, "GFLOP/s", "best", instruction_set=isa)
        shares.append(
            results.add(
                "bulk/share_of_peak", 100 * reached / max(samples), "%", "best", instruction_set=isa
            )
        )
    blank = ["", ""]
    return [
        ["peak of + and * [GFLOP/s]", *(f"{peak['value']:.1f}" for peak in peaks), *blank],
        ["bulk/step, share of it [%]", *(f"{share['value']:.0f}" for share in shares), *blank],
    ]


def lammps(measured, results, lines):
    """The bulk in LAMMPS, and how many times longer it takes there."""
    best, version = read_lammps(lines)
    if not best:
        print("\nNothing was measured with LAMMPS (Debian package: lammps).")
        return
    table = []
    for name, samples in best.items():
        theirs = results.add(name, min(samples), "us", "best", samples, version=version)
        row = [name, f"{theirs['value']:.2f}"]
        for isa in measured.instruction_sets:
            ours = min(measured.times("bulk/step", 1e6, isa))
            ratio = results.add(
                f"{name}/bulk", theirs["value"] / ours, "1", "best / best", instruction_set=isa
            )
            row.append(f"{ratio['value']:.1f}" if name == "lammps/damping" else "")
        table.append(row)
    print_table(
        f"The same bulk in LAMMPS ({version}); lammps/damping is what bulk/step does",
        ["", "us per step", *(f"/ bulk {isa}" for isa in measured.instruction_sets)],
        table,
    )


def recording(measured, results, row, key, text, at_most):
    """What a record costs: `key` says in which part of the run."""
    samples = [100 * cost for cost in measured.values(row, key)]
    result = results.add(
        row + key.removeprefix("cost"),
        median(samples),
        "%",
        "median of paired runs",
        samples,
        at_most=at_most,
        instruction_set=measured.widest,
    )
    target = [result.get("target", ""), met(result) if "met" in result else ""]
    return [f"{row}, {text}", f"{result['value']:.1f}", "%", *target, result["statistic"]]


def once(measured, results):
    table = []
    for row in measured.rows("once"):
        name = row.split("/")[1]
        samples = measured.times(row, 1e3)
        result = results.add(
            row,
            min(samples),
            "ms",
            "best",
            samples,
            at_most=ONCE_TARGETS.get(name),
            instruction_set=measured.widest,
        )
        table.append(
            [
                row,
                f"{result['value']:.2f}",
                "ms",
                result.get("target", ""),
                met(result) if "met" in result else "",
                "best",
            ]
        )
    if measured.rows("record"):
        plain = measured.values("record/cost", "us_without")
        results.add("record/step_without", min(plain), "us", "best", plain)
    table += [
        recording(measured, results, row, key, text, at_most)
        for row in measured.rows("record")
        for key, text, at_most in (
            ("cost_running", "before the end of the run", RECORD_TARGET),
            ("cost", "with finishing the file", RECORD_TARGET if row == "record/cost" else None),
        )
    ]
    if measured.rows("memory"):
        samples = [rate * 1e-9 for rate in measured.values("memory/rewrite", "items_per_second")]
        result = results.add("memory/rewrite", max(samples), "GB/s", "best", samples)
        table.append(["memory/rewrite", f"{result['value']:.1f}", "GB/s", "", "", "best"])
    print_table(
        f"Once in a while, 57 x 31 blocks, {measured.widest}",
        ["", "value", "unit", "target", "met", "what"],
        table,
    )


def last_level_cache(context):
    return max((cache["size"] for cache in context.get("caches", [])), default=0)


def sizes(measured, results):
    """How time per block and memory grow."""
    rows = sorted(measured.rows("size"))
    if not rows:
        return
    cache = last_level_cache(measured.context)
    table, thread_table, first = [], [], None
    for row in rows:
        entry = measured.entries[row, measured.widest][0]
        blocks = entry["Nx"] * entry["Nz"]
        size = f"{entry['Nx']:.0f} x {entry['Nz']:.0f}"
        facts = {
            "Nx": int(entry["Nx"]),
            "Nz": int(entry["Nz"]),
            "junctions": int(entry["junctions"]),
            "instruction_set": measured.widest,
        }
        in_cache = entry["swept_bytes"] <= cache
        samples = measured.values(row, "us_1")
        step = results.add("size/step", min(samples), "us", "best", samples, threads=1, **facts)
        per_block = 1e3 * step["value"] / blocks
        first = first or per_block
        growth = results.add(
            "size/growth_per_block",
            per_block / first,
            "1",
            "best / best",
            at_most=GROWTH_IN_CACHE if in_cache else GROWTH_BEYOND,
            **facts,
        )
        rate = results.add("size/traffic", BYTES_PER_BLOCK / per_block, "GB/s", "best", **facts)
        memory = results.add(
            "size/memory_per_block",
            entry["state_bytes"] / blocks,
            "byte",
            "computed",
            measured=entry["resident_bytes"] / blocks,
            **facts,
        )
        table.append(
            [
                size,
                f"{entry['junctions']:,.0f}",
                f"{entry['swept_bytes'] / 2**20:.1f}",
                f"{step['value']:.1f}",
                f"{per_block:.2f}",
                f"{growth['value']:.2f}",
                growth["target"],
                met(growth),
                f"{rate['value']:.1f}",
                f"{memory['value']:.0f}",
                f"{memory['measured']:.0f}",
            ]
        )
        for name in entry:
            if not re.fullmatch(r"us_\d+", name) or name == "us_1":
                continue
            threads = int(name[3:])
            samples = measured.values(row, name)
            shared = results.add(
                "size/step", min(samples), "us", "best", samples, threads=threads, **facts
            )
            speedup = results.add(
                "size/speedup",
                step["value"] / shared["value"],
                "1",
                "best / best",
                at_least=SPEEDUP_TARGET if threads == 2 and blocks >= SPEEDUP_FROM else None,
                threads=threads,
                **facts,
            )
            samples = measured.values(row, f"speedup_{threads}")
            paired = results.add(
                "size/speedup_paired",
                median(samples),
                "1",
                "median of paired runs",
                samples,
                threads=threads,
                **facts,
            )
            thread_table.append(
                [
                    size,
                    threads,
                    f"{step['value']:.1f}",
                    f"{shared['value']:.1f}",
                    f"{speedup['value']:.2f}",
                    speedup.get("target", ""),
                    met(speedup) if "met" in speedup else "",
                    f"{paired['value']:.2f}",
                ]
            )
    print_table(
        f"Larger sliders, {measured.widest}, 1 thread; the last cache has "
        f"{cache / 2**20:.0f} MiB",
        [
            "blocks",
            "junctions",
            "MiB swept",
            "us/step",
            "ns/block",
            "growth",
            "target",
            "met",
            "GB/s",
            "B/block",
            "measured",
        ],
        table,
    )
    if thread_table:
        print_table(
            f"Threads, {measured.widest}",
            ["blocks", "threads", "us with 1", "us", "speedup", "target", "met", "paired"],
            thread_table,
        )


def main(arguments):
    output, *paths = arguments[: arguments.index("--lammps")]
    lines = arguments[arguments.index("--lammps") + 1]
    measured = Measurements(paths)
    context = measured.context
    results = Results()

    host = machine()
    host["caches"] = context.get("caches", [])
    build = {
        key: context[key].strip()
        for key in (
            "rupture_version",
            "rupture_commit",
            "compiler",
            "build_type",
            "flags",
            "kernel_flags",
        )
    }
    print(
        f"rupture {build['rupture_version']} ({build['rupture_commit']}), {build['compiler']}, "
        f"{build['build_type']} ({build['flags']})"
    )
    print(
        f"{host['processor']}, {host['processors']} processors, load up to {measured.load:.1f}; "
        f"{context['date']}"
    )
    if measured.load > host["processors"] + 0.5:
        print("Other programs were running: threads and files suffer from that first. Repeat it.")

    table = steps(measured, results) + roofline(measured, results)
    print_table(
        "Time per step and of its parts, 57 x 31 blocks, 5,700 junctions [us], best",
        ["", *measured.instruction_sets, "target", "met"],
        table,
    )
    print(f"  {FLOPS_PER_BLOCK} flops and {BYTES_PER_BLOCK} bytes per block and step")
    lammps(measured, results, lines)
    once(measured, results)
    sizes(measured, results)

    document = {
        "machine": host,
        "build": build,
        "date": context["date"],
        "largest_load": measured.load,
        "flops_per_block_and_step": FLOPS,
        "bytes_per_block_and_step": BYTES_PER_BLOCK,
        "results": results.list,
    }
    with open(output, "w", encoding="utf-8") as file:
        json.dump(document, file, indent=1)
        file.write("\n")
    missed = sum(1 for result in results.list if result.get("met") is False)
    print(f"\n{missed} targets missed. Everything in {output}")


if __name__ == "__main__":
    main(sys.argv[1:])
