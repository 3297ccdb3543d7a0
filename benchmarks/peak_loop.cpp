// Sums and products on registers alone, compiled once per instruction set: PEAK_ISA names this
// variant, PEAK_LANES is how many doubles its registers hold.
#include <cstddef>

#define PEAK_JOIN_(a, b) a##b
#define PEAK_JOIN(a, b) PEAK_JOIN_(a, b)

namespace rupture::bench {

/// Floating-point operations in one round.
extern const std::ptrdiff_t PEAK_JOIN(peak_flops_, PEAK_ISA);
double PEAK_JOIN(peak_, PEAK_ISA)(std::ptrdiff_t rounds, double summand, double factor);

namespace {

typedef double Lanes __attribute__((vector_size(PEAK_LANES * sizeof(double))));

/// Sums, and as many products, that do not wait for one another: with their operands, they fill 16
/// registers.
constexpr int kChains = 7;

}  // namespace

const std::ptrdiff_t PEAK_JOIN(peak_flops_, PEAK_ISA) = 2 * kChains * PEAK_LANES;

double PEAK_JOIN(peak_, PEAK_ISA)(std::ptrdiff_t rounds, double summand, double factor) {
  Lanes sum[kChains], product[kChains];
  for (int c = 0; c < kChains; ++c) {  // all different, lest the compiler compute one for all
    sum[c] = Lanes{} + (1.0 + c);
    product[c] = Lanes{} + (1.5 + c);
  }
  for (std::ptrdiff_t n = 0; n < rounds; ++n) {
    for (int c = 0; c < kChains; ++c) {
      sum[c] = sum[c] + summand;
      product[c] = product[c] * factor;
    }
  }
  Lanes all = {};
  for (int c = 0; c < kChains; ++c) all = all + (sum[c] + product[c]);
  double result = 0.0;
  for (int lane = 0; lane < PEAK_LANES; ++lane) result += all[lane];
  return result;
}

}  // namespace rupture::bench
