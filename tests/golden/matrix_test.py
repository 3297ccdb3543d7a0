"""Builds the programs that make states as a line of matrix.txt says. They go on from the files of
tests/compatibility, and give the golden checksums. The `analyze` that is tested reads both. Clang's
build has sanitizers, and a fuzzer, which searches for 15 s in the same tree."""

import os
import subprocess
from pathlib import Path

import pytest

from conftest import BIN, BUILD, ROOT, SKIPPED, need, skip

HERE = Path(__file__).parent
LINES = [line.split() for line in (HERE / "matrix.txt").read_text().splitlines()]
BUILDS = {name: words for name, *words in LINES if name != "#"}
PROGRAMS = ("load", "prepare", "restart", "modify-phi")
# As fast as it can be compiled: the states come from the library, so the programs need no
# optimisation and are compiled once per compiler, and all files of a target are one.
FAST = """-G Ninja -DCMAKE_BUILD_TYPE=None -DRUPTURE_PROGRAM_FLAGS=-O0 -DCMAKE_UNITY_BUILD=ON
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DRUPTURE_WERROR=OFF
    -DRUPTURE_TESTS=OFF -DRUPTURE_BENCHMARKS=OFF"""
TARGET = 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }'
SANITIZED = """-DRUPTURE_TESTS=ON -DRUPTURE_FUZZ=ON -DRUPTURE_SANITIZE=address,undefined
    -DRUPTURE_TEST_FLAGS=-O1"""
os.environ.setdefault("ASAN_OPTIONS", "detect_leaks=0")  # libhdf5 keeps memory until the end


def succeeds(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode == SKIPPED:
        skip(done.stdout)
    print(done.stdout)
    assert done.returncode == 0


def build(folder, level, *choice, targets=PROGRAMS):
    flags = f"-DRUPTURE_LIBRARY_FLAGS={level}", f"-DRUPTURE_KERNEL_FLAGS={level}"
    succeeds("cmake", "-S", ROOT, "-B", folder, *FAST.split(), *flags, *choice)
    succeeds("cmake", "--build", folder, "--parallel", "1", "--target", *targets)
    return folder / "bin"


def build_sanitized(folder, compiler, level):
    need(compiler)
    command = (compiler, "-fsanitize=fuzzer,address", "-x", "c++", "-", "-o", os.devnull)
    if subprocess.run(command, input=TARGET, capture_output=True, text=True).returncode:
        skip(f"{compiler} has no fuzzer (libclang-rt-dev).")
    c_compiler = compiler.replace("clang++", "clang")
    choice = f"-DCMAKE_C_COMPILER={c_compiler}", f"-DCMAKE_CXX_COMPILER={compiler}"
    return build(folder, level, *choice, *SANITIZED.split(), targets=(*PROGRAMS, "fuzz"))


def build_cross(folder, compiler, level, architecture):
    """In place of each program for another processor, a script that runs it."""
    processor = compiler.partition("-")[0]
    need(compiler, f"qemu-{processor}")
    succeeds(HERE / "sysroot.sh", architecture, folder.parent)
    sysroot = folder.with_name(f"sysroot-{architecture}")
    toolchain = ROOT / f"cmake/{processor}.cmake"
    programs = build(folder, level, f"--toolchain={toolchain}", f"-DCMAKE_SYSROOT={sysroot}")
    scripts = folder / "emulated"
    scripts.mkdir(exist_ok=True)
    for name in PROGRAMS:
        run_it = f"exec qemu-{processor} -L '{sysroot}' '{programs}/{name}' \"$@\""
        (scripts / name).write_text(f"#!/bin/bash\n{run_it}\n")
        (scripts / name).chmod(0o755)
    return scripts


@pytest.mark.parametrize("name", BUILDS)
def test_gives_the_golden_checksums(name):
    folder = BUILD.resolve() / "matrix" / BUILDS[name][0]
    make = build_cross if BUILDS[name][2:] else build_sanitized
    programs = make(folder, *BUILDS[name])  # type: ignore[operator]
    (programs / "analyze").unlink(missing_ok=True)
    (programs / "analyze").symlink_to((BIN / "analyze").resolve())
    for file in (ROOT / "tests/compatibility").glob("schema-3/*.h5"):
        if not file.name.endswith("record.h5"):
            end = folder / "next.h5"
            succeeds(programs / "restart", file, "-q", "-f", "--for", "2e-5", "-o", end)
            succeeds(BIN / "analyze", "verify", end)
    succeeds(HERE / "golden.sh", "check", programs, folder / "golden")
    if make is build_sanitized:
        search(folder)


def search(folder):
    """New inputs are kept in `found`; one that breaks something, beside it."""
    (folder / "found").mkdir(exist_ok=True)
    limits = "-max_total_time=15", "-timeout=10", "-rss_limit_mb=2048"
    corpus = ROOT / "tests/fuzz/corpus"
    succeeds(folder / "bin/fuzz", *limits, f"-artifact_prefix={folder}/", folder / "found", corpus)
