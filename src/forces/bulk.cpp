#include "rupture/forces/bulk.hpp"

#include <array>
#include <cmath>

#include "rupture/model/derived.hpp"

namespace rupture {

Bulk::Bulk(const Parameters& p)
    : springs_{block_spacing(p), bulk_stiffness(p)},
      eta_(damping_coefficient(p)),
      mass_(block_mass(p)) {
  const Eigen::Index stride = Field(p.Nx, p.Nz).stride();
  rows_.assign(static_cast<std::size_t>(3 * stride), 0.0);
  scratch_.assign(static_cast<std::size_t>(kScratchRows * (stride + 8)), 0.0);
  double* has_right = rows_.data();
  double* inside = has_right + stride;
  double* columns = inside + stride;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    has_right[i] = i + 1 < p.Nx ? 1.0 : 0.0;
    inside[i] = 1.0;
    columns[i] = i == 0 || i + 1 == p.Nx ? 2.0 : 3.0;
  }
  shape_ = {p.Nx, p.Nz, stride, has_right, inside, columns};
}

void Bulk::elastic(const Field& u_x, const Field& u_z, Field& f_x, Field& f_z) {
  kernels().elastic(shape_, springs_, view(u_x, u_z), view(f_x, f_z), scratch_.data());
}

void Bulk::damping(const Field& v_x, const Field& v_z, Field& f_x, Field& f_z) {
  kernels().damping(shape_, eta_, view(v_x, v_z), view(f_x, f_z));
}

double Bulk::finish(double half_kick, const Boundary& boundary, State& state) {
  return kernels().finish(shape_, springs_, eta_, half_kick, {state.u_x.row(0), state.u_z.row(0)},
                          boundary, view(state.f_x, state.f_z), view(state.v_x, state.v_z),
                          scratch_.data());
}

double Bulk::elastic_energy(const Field& u_x, const Field& u_z) const {
  struct Bond {
    int ix, iz;
  };
  constexpr std::array<Bond, 4> bonds = {{{1, 0}, {0, 1}, {1, 1}, {-1, 1}}};
  const double l = springs_.l;
  double energy = 0.0;
  for (Eigen::Index j = 0; j < shape_.Nz; ++j) {
    for (Eigen::Index i = 0; i < shape_.Nx; ++i) {
      for (const auto [ix, iz] : bonds) {
        if (i + ix < 0 || i + ix >= shape_.Nx || j + iz >= shape_.Nz) continue;
        const double n = ix * ix + iz * iz;
        const double dx = u_x(i + ix, j + iz) - u_x(i, j);
        const double dz = u_z(i + ix, j + iz) - u_z(i, j);
        const double s = ((2 * ix * l + dx) * dx + (2 * iz * l + dz) * dz) / (n * l * l);
        const double stretch = std::sqrt(n) * l * s / (std::sqrt(1.0 + s) + 1.0);
        energy += 0.5 * (springs_.k / n) * stretch * stretch;
      }
    }
  }
  return energy;
}

double Bulk::kinetic_energy(const Field& v_x, const Field& v_z) const {
  return 0.5 * mass_ * (v_x.blocks().square().sum() + v_z.blocks().square().sum());
}

}  // namespace rupture
