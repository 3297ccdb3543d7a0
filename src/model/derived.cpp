#include "rupture/model/derived.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rupture/model/contact_formulas.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {

double block_spacing(const Parameters& p) {
  return p.L / static_cast<double>(p.Nx - 1);
}
double spring_length(const Parameters& p) {
  return p.springs == BulkSprings::linearised ? 0x1p60 * block_spacing(p) : block_spacing(p);
}
double block_mass(const Parameters& p) {
  return p.M / static_cast<double>(p.Nx * p.Nz);
}
double bulk_stiffness(const Parameters& p) {
  return 3.0 * p.B * p.E / 4.0;
}
double damping_coefficient(const Parameters& p) {
  return std::sqrt(p.damping * bulk_stiffness(p) * block_mass(p));
}
double foundation_stiffness(const Parameters& p) {
  return p.foundation * bulk_stiffness(p);
}
double foundation_damping_coefficient(const Parameters& p) {
  return std::sqrt(p.foundation_damping * foundation_stiffness(p) * block_mass(p));
}
double density(const Parameters& p) {
  return p.M / (p.L * p.H * p.B);
}
double shear_wave_speed(const Parameters& p) {
  return std::sqrt(p.E / (2.0 * (1.0 + kPoissonRatio)) / density(p));
}
double mean_normal_force(const Parameters& p) {
  return p.F_N / static_cast<double>(p.Nx);
}
double column_load(const Parameters& p, std::int64_t i) {
  return mean_normal_force(p) * p.load[i];
}

double spring_stiffness(const Parameters& p, std::int64_t i, std::int64_t j, int ix, int iz) {
  const bool on_face = (iz == 0 && (j == 0 || j + 1 == p.Nz)) ||  //
                       (ix == 0 && (i == 0 || i + 1 == p.Nx));
  const double part = on_face && p.edge_springs == EdgeSprings::half ? 0.5 : 1.0;
  return part * bulk_stiffness(p) / static_cast<double>(ix * ix + iz * iz);
}

double block_position(const Parameters& p, std::int64_t i) {
  return static_cast<double>(i) * block_spacing(p);
}

std::vector<double> block_positions(const Parameters& p) {
  std::vector<double> x;
  for (std::int64_t i = 0; i < p.Nx; ++i) x.push_back(block_position(p, i));
  return x;
}

std::vector<double> block_heights(const Parameters& p) {
  std::vector<double> z;
  for (std::int64_t j = 0; j < p.Nz; ++j) z.push_back(static_cast<double>(j) * block_spacing(p));
  return z;
}

std::int64_t driving_row(const Parameters& p) {
  return static_cast<std::int64_t>(std::llround(p.h / block_spacing(p)));
}

std::int64_t springs_per_block(const Parameters& p) {
  return law_info(p.law).springs == SpringsPerBlock::one ? 1 : p.N_s;
}

double junction_stiffness(const Parameters& p, std::int64_t i, double p_i) {
  const bool initial = p.k_ij_from == StiffnessFrom::initial && p_i > 0.0;
  return junction_stiffness(p.kappa[i], static_cast<double>(p.N_s),
                            initial ? column_load(p, i) : p_i);
}

double mean_slipping_time(const Parameters& p, std::int64_t i) {
  const double t_R = p.t_R[i], delta = p.delta_t_R[i];
  if (p.slipping_times == SlippingTimes::exponential || delta == 0.0) return t_R;
  const double ratio = t_R / (std::numbers::sqrt2 * delta);
  return delta * std::sqrt(2.0 / std::numbers::pi) * std::exp(-ratio * ratio) +
         t_R * std::erf(ratio);
}

double friction_stretch(const Parameters& p, std::int64_t i, double p_i) {
  const double k_ij = junction_stiffness(p, i, p_i);
  if (p.k_ij_from == StiffnessFrom::current) return friction_stretch(p.kappa[i], k_ij, p_i);
  return p_i > 0.0 ? p_i / static_cast<double>(p.N_s) / k_ij : 0.0;
}

double stable_time_step(const Parameters& p) {
  const double edge_pressure = 4.0;  // corner blocks bear a few times the mean normal force
  return stable_time_step(p, edge_pressure * mean_normal_force(p) * p.load.largest());
}

double stable_time_step(const Parameters& p, double largest_p) {
  const double k = bulk_stiffness(p);
  const double m = block_mass(p);
  const double largest_load = mean_normal_force(p) * p.load.largest();
  const double k_ij =
      junction_stiffness(p.kappa.largest(), static_cast<double>(p.N_s),
                         p.k_ij_from == StiffnessFrom::initial ? largest_load : largest_p);
  const double k_i = static_cast<double>(p.N_s) * k_ij;
  const double interface = driving_row(p) == 0 ? k_i + p.K : k_i;
  const double surface = std::max({interface, foundation_stiffness(p), p.K});
  const double omega = std::sqrt(std::max(6.0 * k, 5.0 * k + surface)) / std::sqrt(m);
  const double bonds = p.damping_along == DampingAlong::spring ? 8.0 : 12.0;
  const double c = bonds * damping_coefficient(p) / m + foundation_damping_coefficient(p) / m;
  return 4.0 / (std::hypot(c, 2.0 * omega) + c);  // the formula of the header without cancellation
}

}  // namespace rupture
