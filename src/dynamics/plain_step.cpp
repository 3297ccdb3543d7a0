#include "rupture/dynamics/plain_step.hpp"

#include <algorithm>

#include "rupture/model/derived.hpp"
#include "rupture/model/normal_contact.hpp"

namespace rupture {

void plain_step(const Parameters& p, double dt, Bulk& bulk, State& s, const AddForces& add_forces) {
  const auto half_kick = [&] {  // v += (dt/2) f/m
    s.v_x.blocks() += dt / (2.0 * block_mass(p)) * s.f_x.blocks();
    s.v_z.blocks() += dt / (2.0 * block_mass(p)) * s.f_z.blocks();
  };
  half_kick();
  s.u_x.blocks() += dt * s.v_x.blocks();
  s.u_z.blocks() += dt * s.v_z.blocks();
  ++s.step;

  Field damping_x(p.Nx, p.Nz), damping_z(p.Nx, p.Nz);
  bulk.elastic(s.u_x, s.u_z, s.f_x, s.f_z);
  bulk.damping(s, damping_x, damping_z);  // at the half-kicked velocity
  s.f_x.blocks() += damping_x.blocks();
  s.f_z.blocks() += damping_z.blocks();
  add_forces(s);
  half_kick();
}

void add_outer_forces(const Parameters& p, InterfaceLaw& law, State& s) {
  std::vector<double> p_i, k_ij, w, tau(static_cast<std::size_t>(p.Nx));
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    const double normal = p_i.emplace_back(NormalContact(p, i).normal_force(s.u_z(i, 0)));
    k_ij.push_back(junction_stiffness(p, i, normal));
    w.push_back(normal > 0.0 ? normal / static_cast<double>(p.N_s) / k_ij.back() : 0.0);
  }
  const ContactView contact = {p_i.data(), k_ij.data(), w.data()};
  law.update(s.u_x.row(0), s.v_x.row(0), contact, time(p, s));
  law.friction(s.u_x.row(0), contact, tau.data());

  const double eta_f = foundation_damping_coefficient(p);
  const auto damped = [&](double force, double inwards) {  // it never pulls
    return force > 0.0 ? std::max(force + eta_f * inwards, 0.0) : 0.0;
  };
  const bool is_below = !has_constant_p(p);  // the support, and so its dashpots
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto block = static_cast<std::size_t>(i);
    const double down = NormalContact(p, i).top_force(s.u_z(i, p.Nz - 1));
    s.f_x(i, 0) -= tau[block];
    s.f_z(i, 0) += is_below ? damped(p_i[block], -s.v_z(i, 0)) : p_i[block];
    s.f_z(i, p.Nz - 1) -= is_below ? down : damped(down, s.v_z(i, p.Nz - 1));
  }
  const double x_drive =
      s.drive.origin_position + p.V * p.dt * static_cast<double>(s.step - s.drive.origin_step);
  s.f_x(0, driving_row(p)) += p.K * (x_drive - s.u_x(0, driving_row(p)));
}

}  // namespace rupture
