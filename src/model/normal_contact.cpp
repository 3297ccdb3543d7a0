#include "rupture/model/normal_contact.hpp"

#include <algorithm>

#include "rupture/model/contact_formulas.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {

NormalContact::NormalContact(const Parameters& p, std::int64_t i)
    : support_(p.support),
      k_f_(foundation_stiffness(p)),
      load_(column_load(p, i)),
      strain_(p.F_N / (p.L * p.B) / p.E),
      H_(p.H) {}

double NormalContact::normal_force(double u_z) const {
  return support_ == Support::ceiling ? load_ : foundation_force(k_f_, u_z);
}

double NormalContact::top_force(double u_z) const {
  return support_ == Support::ceiling ? k_f_ * std::max(u_z, 0.0) : load_;
}

double NormalContact::normal_force_slope(double u_z) const {
  return support_ == Support::foundation && u_z < 0.0 ? -k_f_ : 0.0;
}

double NormalContact::top_force_slope(double u_z) const {
  return support_ == Support::ceiling && u_z > 0.0 ? k_f_ : 0.0;
}

double NormalContact::compression(double bottom, double top) const {
  return support_ == Support::foundation ? -bottom : top;
}

double NormalContact::contact_energy(double bottom, double top) const {
  const double pressed = std::max(compression(bottom, top), 0.0);
  return 0.5 * k_f_ * pressed * pressed;
}

double NormalContact::load_energy(double bottom, double top) const {
  return load_ * (support_ == Support::foundation ? top : -bottom);
}

double NormalContact::compressed_u_z(double z) const {
  const double sink = load_ / k_f_;
  return support_ == Support::foundation ? -sink - strain_ * z : sink + strain_ * (H_ - z);
}

}  // namespace rupture
