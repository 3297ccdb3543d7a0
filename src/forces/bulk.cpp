#include "rupture/forces/bulk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

/// Coefficients c_n of 1 - 1/sqrt(1+s) = s sum_n c_n s^n.
constexpr std::array<double, kTensionTerms> kTensionSeries = {
    1.0 / 2, -3.0 / 8, 5.0 / 16, -35.0 / 128, 63.0 / 256, -231.0 / 1024};

/// |s| up to which these terms give the tension to the last digit: the next is 429/2048 s^6.
constexpr double kSmallStrain = 1.0 / 400;

}  // namespace

Bulk::Bulk(const Parameters& p, int bands)
    : kernels_(kernels()),
      parameters_(p),
      shape_{p.Nx, p.Nz, Field(p.Nx, p.Nz).stride()},
      mass_(block_mass(p)),
      half_kick_(p.dt / (2.0 * block_mass(p))),
      dt_(p.dt),
      damping_power_(static_cast<std::size_t>(p.Nz)),
      bottom_velocity_(static_cast<std::size_t>(shape_.stride)) {
  enum Row { kRight, kFace, kUp, kDiagonal, kNone, kSmallRight, kEta, kEtaRight, kColumns, kRows };
  rows_.assign(static_cast<std::size_t>(kRows * shape_.stride), 0.0);
  const auto row = [this](Row r) { return rows_.data() + r * shape_.stride; };

  const double l = spring_length(p), l2 = l * l;
  springs_.l = l;
  double scale = l2;
  for (std::size_t n = 0; n < kTensionTerms; ++n) {
    springs_.series[n] = kTensionSeries[n] / scale;
    scale *= l2;
  }
  springs_.small = (kSmallStrain * l2) * (kSmallStrain * l2);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const bool is_last = i + 1 == p.Nx;
    row(kRight)[i] = is_last ? 0.0 : spring_stiffness(p, i, 1, 1, 0);
    row(kFace)[i] = is_last ? 0.0 : spring_stiffness(p, i, 0, 1, 0);
    row(kUp)[i] = spring_stiffness(p, i, 0, 0, 1);
    row(kDiagonal)[i] = is_last ? 0.0 : spring_stiffness(p, i, 0, 1, 1);
    row(kEta)[i] = damping_coefficient(p);
    row(kEtaRight)[i] = is_last ? 0.0 : damping_coefficient(p);
    row(kColumns)[i] = i == 0 || is_last ? 2.0 : 3.0;
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::fill_n(row(kSmallRight), shape_.stride, infinite);
  std::fill_n(row(kSmallRight), p.Nx - 1, springs_.small);
  springs_.small_right = row(kSmallRight);
  springs_.row = {row(kRight), row(kUp), row(kDiagonal)};
  springs_.bottom_row = {row(kFace), row(kUp), row(kDiagonal)};
  springs_.top_row = {row(kFace), row(kNone), row(kNone)};
  dampers_ = {row(kEta), row(kColumns), {}, {}};
  if (p.damping_along == DampingAlong::spring) {
    dampers_.row = {row(kEtaRight), row(kEta), row(kEtaRight)};
    dampers_.top_row = {row(kEtaRight), row(kNone), row(kNone)};
  }

  const Eigen::Index count = std::clamp<Eigen::Index>(bands, 1, p.Nz);
  const Eigen::Index size = kernels_.scratch_size(shape_);
  scratch_.assign(static_cast<std::size_t>(count * size), 0.0);
  for (Eigen::Index b = 0; b < count; ++b) {
    bands_.push_back({b * p.Nz / count, (b + 1) * p.Nz / count, scratch_.data() + b * size});
  }
}

void Bulk::elastic(const Field& u_x, const Field& u_z, Field& f_x, Field& f_z) {
  kernels_.elastic(shape_, springs_, view(u_x, u_z), view(f_x, f_z), bands_.front());
}

void Bulk::damping(const State& s, Field& f_x, Field& f_z) {
  kernels_.damping(shape_, springs_, dampers_, view(s.u_x, s.u_z), view(s.v_x, s.v_z),
                   view(f_x, f_z), bands_.front());
}

Motion Bulk::motion(State& state) const {
  return {view(state.u_x, state.u_z), view(state.v_x, state.v_z), view(state.f_x, state.f_z),
          half_kick_, dt_};
}

void Bulk::half_kick_and_drift(int b, State& state) const {
  kernels_.kick_drift(shape_, motion(state), band(b));
}

void Bulk::keep_neighbouring_rows(int b, State& state) const {
  kernels_.prepare(shape_, springs_, dampers_, motion(state), band(b));
}

void Bulk::add_forces_and_half_kick(int b, const Boundary& boundary, Then then, State& state) {
  kernels_.finish(shape_, springs_, dampers_, boundary, motion(state), band(b), then,
                  {damping_power_.data(), bottom_velocity_.data()});
}

double Bulk::damping_power() const {
  return std::accumulate(damping_power_.begin(), damping_power_.end(), 0.0);
}

double Bulk::elastic_energy(const Field& u_x, const Field& u_z) const {
  const double l = springs_.l;
  double energy = 0.0;
  for_each_spring(parameters_, [&](Eigen::Index i, Eigen::Index j, int ix, int iz) {
    const double n = ix * ix + iz * iz;
    const double dx = u_x(i + ix, j + iz) - u_x(i, j);
    const double dz = u_z(i + ix, j + iz) - u_z(i, j);
    const double s = ((2 * ix * l + dx) * dx + (2 * iz * l + dz) * dz) / (n * l * l);
    const double stretch = std::sqrt(n) * l * s / (std::sqrt(1.0 + s) + 1.0);
    energy += 0.5 * spring_stiffness(parameters_, i, j, ix, iz) * stretch * stretch;
  });
  return energy;
}

double Bulk::kinetic_energy(const Field& v_x, const Field& v_z) const {
  return 0.5 * mass_ * (v_x.blocks().square().sum() + v_z.blocks().square().sum());
}

}  // namespace rupture
