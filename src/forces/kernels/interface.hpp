// Normal contact and the junctions' trailing.
#pragma once

#include "lanes.hpp"
#include "rupture/forces/kernels.hpp"
#include "rupture/model/contact_formulas.hpp"
#include "rupture/model/never.hpp"

namespace rupture {
namespace {

void contact(Index Nx, const double* u_z, double k_f, double N_s, const double* kappa,
             ContactView out) {
  double* p = out.p;
  double* k_ij = out.k_ij;
  double* w = out.w;
#pragma omp simd
  for (Index i = 0; i < Nx; ++i) {
    const double p_i = foundation_force(k_f, u_z[i]);
    const double k = junction_stiffness(kappa[i], N_s, p_i);
    p[i] = p_i;
    k_ij[i] = k;
    w[i] = friction_stretch(kappa[i], k, p_i);
  }
}

double trail(Index N_s, double lower, double upper, const double* repin_time, double* attachment) {
  double lanes[kParts] = {};
  const Index whole = N_s - N_s % 8;
  const auto trailed = [&](Index j) {
    const double a = attachment[j];
    const double high = a > lower ? a : lower;
    const double clamped = high < upper ? high : upper;
    return repin_time[j] < kNever ? clamped : a;
  };
  for (Index first = 0; first < whole; first += 8) {
#pragma omp simd
    for (Index lane = 0; lane < 8; ++lane) {
      const double a = trailed(first + lane);
      attachment[first + lane] = a;
      lanes[lane] += a;
    }
  }
  for (Index j = whole; j < N_s; ++j) {
    attachment[j] = trailed(j);
    lanes[j - whole] += attachment[j];
  }
  return sum_of_parts(lanes);
}

}  // namespace
}  // namespace rupture
