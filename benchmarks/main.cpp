// All benchmarks, with the instruction set that RUPTURE_ISA names or the widest one. See README.md.
#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>
#include <string>

#include "rupture/checkpoint/provenance.hpp"
#include "rupture/forces/kernels.hpp"

int main(int argc, char** argv) {
  try {
    const auto build = rupture::make_provenance("bench", {}, "", "");
    benchmark::AddCustomContext("rupture_version", build.version);
    benchmark::AddCustomContext("rupture_commit", build.commit);
    benchmark::AddCustomContext("compiler", build.compiler);
    benchmark::AddCustomContext("build_type", BENCH_BUILD_TYPE);
    benchmark::AddCustomContext("flags", BENCH_FLAGS);
    benchmark::AddCustomContext("kernel_flags", BENCH_KERNEL_FLAGS);
    benchmark::AddCustomContext("instruction_set", std::string(rupture::kernels().name));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bench: " << error.what() << '\n';
    return 1;
  }
}
