// Whether this file was compiled to operations that round as IEEE 754 says: what the options did is
// seen here, whatever they are called. As in isa.cpp, no library header with inline functions may
// be included.
#pragma once

#include <math.h>

#include "rupture/model/exact_arithmetic.hpp"

namespace rupture {
namespace {

/// What this file computes otherwise than it must, of numbers that the compiler cannot know; null
/// if nothing.
inline const char* inexactness() {
  const char* fault = nullptr;
  const auto demand = [&fault](auto result, double expected, const char* otherwise) {
    const bool is_exact = __builtin_memcmp(&result, &expected, sizeof expected) == 0;
    if (fault == nullptr && !is_exact) fault = otherwise;
  };
  const auto unknown = [](double x, auto unit) {
    volatile double hidden = x;
    return unit * hidden;
  };
  const auto operate = [&](auto unit) {
    const auto some = [&](double x) { return unknown(x, unit); };
    const auto one = some(1.0), odd = some(1.0 + 0x1p-30), big = some(0x1p53);
    demand((big + one) - big, 0.0, "sums are reordered");
    demand(odd * odd - some(1.0 + 0x1p-29), 0.0, "a product is not rounded before a sum");
    demand(some(49.0) / 49.0, 1.0, "divisions are replaced by products");
    demand(one + 0x1p-53, 1.0, "results are not rounded to the nearest number");
    demand(one + 0x1.8p-53, 1.0 + 0x1p-52, "results are not rounded to the nearest number");
    demand(some(-0.0) + 0.0, 0.0, "the sign of 0 is lost");
    demand(0.0 - some(0.0), 0.0, "the sign of 0 is lost");
    demand(some(0x1p-1022) / 2.0, 0x1p-1023, "subnormal results become 0");
    demand(some(0x1p-1074) * 0x1p52, 0x1p-1022, "subnormal numbers are taken for 0");
  };
  typedef double Two __attribute__((vector_size(2 * sizeof(double))));
  operate(1.0);
  operate(Two{1.0, 1.0});  // of which the first counts; compilers treat both differently
  demand(sqrt(unknown(2.0, 1.0)), 0x1.6a09e667f3bcdp0, "square roots are approximated");
  demand(1.0 / unknown(10.0, 1.0), 0.1, "constants lack digits");
  const double no_number = unknown(__builtin_nan(""), 1.0);
  demand(no_number == no_number ? 1.0 : 0.0, 0.0, "NaN is not known");

  double terms[64], sum = 0.0;
  for (double& term : terms) term = unknown(1.0, 1.0);
  terms[0] = unknown(0x1p53, 1.0);
  terms[63] = unknown(-0x1p53, 1.0);
  for (const double term : terms) sum += term;  // 0 in this order
  demand(sum, 0.0, "sums are reordered");
  return fault;
}

}  // namespace
}  // namespace rupture
