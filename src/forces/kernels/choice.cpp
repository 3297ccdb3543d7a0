#include <fmt/ranges.h>

#include <cstdlib>
#include <vector>

#include "inexactness.hpp"
#include "rupture/forces/kernels.hpp"
#include "rupture/model/error.hpp"

namespace rupture {

#if defined(__x86_64__)
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
#elif defined(__aarch64__)
extern const Kernels kernels_neon;
#else
extern const Kernels kernels_baseline;
#endif

namespace {

/// The variants that this processor can run, widest first.
std::vector<const Kernels*> available() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  std::vector<const Kernels*> found;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    found.push_back(&kernels_avx512);
  }
  if (__builtin_cpu_supports("avx2")) found.push_back(&kernels_avx2);
  found.push_back(&kernels_sse2);
  return found;
#elif defined(__aarch64__)
  return {&kernels_neon};  // which every such processor has
#else
  return {&kernels_baseline};
#endif
}

const Kernels& choose() {
  check_arithmetic();
  const char* wanted = std::getenv("RUPTURE_ISA");
  if (wanted == nullptr || *wanted == '\0') return *available().front();
  std::vector<std::string_view> names;
  for (const auto* variant : available()) {
    if (variant->name == wanted) return *variant;
    names.push_back(variant->name);
  }
  throw UsageError(
      "RUPTURE_ISA = '{}' is not an instruction set of this processor and build: choose one of {}",
      wanted, fmt::join(names, ", "));
}

}  // namespace

void check_arithmetic() {
  const char* fault = inexactness();
  for (const auto* variant : available()) fault = fault == nullptr ? variant->inexactness() : fault;
  if (fault == nullptr) return;
  throw Failure(
      "this build computes other bits than every other one ({}): build rupture without options of "
      "the compiler and the linker that change floating-point results, such as -ffast-math",
      fault);
}

const Kernels& kernels() {
  static const Kernels& chosen = choose();
  return chosen;
}

}  // namespace rupture
