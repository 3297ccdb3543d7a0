// One vector register of doubles, as wide as the instruction set that is being compiled for.
// Included by isa.cpp only: everything here is private to one variant.
#pragma once

#include <math.h>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <cstddef>

namespace rupture {
namespace {

using Index = std::ptrdiff_t;

/// Arithmetic acts on each of the RUPTURE_LANES lanes.
typedef double Lanes __attribute__((vector_size(RUPTURE_LANES * sizeof(double))));

inline Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline void store(double* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

inline Lanes square_root(Lanes x) {
  for (int lane = 0; lane < RUPTURE_LANES; ++lane) x[lane] = sqrt(x[lane]);
  return x;
}

/// The lanes of `now` moved up by one; the last lane of `before` moves in.
inline Lanes shifted_up(Lanes before, Lanes now) {
#if RUPTURE_LANES == 8
  return __builtin_shufflevector(before, now, 7, 8, 9, 10, 11, 12, 13, 14);
#elif RUPTURE_LANES == 4
  return __builtin_shufflevector(before, now, 3, 4, 5, 6);
#else
  return __builtin_shufflevector(before, now, 1, 2);
#endif
}

/// The lanes of `now` moved down by one; the first lane of `after` moves in.
inline Lanes shifted_down(Lanes now, Lanes after) {
#if RUPTURE_LANES == 8
  return __builtin_shufflevector(now, after, 1, 2, 3, 4, 5, 6, 7, 8);
#elif RUPTURE_LANES == 4
  return __builtin_shufflevector(now, after, 1, 2, 3, 4);
#else
  return __builtin_shufflevector(now, after, 1, 2);
#endif
}

inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

/// True if a > b in any lane.
inline bool any_larger(Lanes a, Lanes b) {
#if RUPTURE_LANES == 8
  return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ) != 0;
#elif RUPTURE_LANES == 4
  return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ)) != 0;
#elif defined(__x86_64__)
  return _mm_movemask_pd(_mm_cmpgt_pd(a, b)) != 0;
#else
  bool any = false;
  for (int lane = 0; lane < RUPTURE_LANES; ++lane) any |= a[lane] > b[lane];
  return any;
#endif
}

/// Lanes that every instruction set sums apart; part 0 takes elements 0, 8, 16, ...
constexpr Index kParts = 8;

/// The sum of eight parts, in an order that no compiler may change.
inline double sum_of_parts(const double* part) {
  return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

}  // namespace
}  // namespace rupture
