// A block that is moved by hand over junctions with easy numbers.
//
// f_N = 1 N and kappa = 4 N/m^2, so k_ij = 2 N/m and w = f_N / k_ij = 0.5 m: with mu_s = 0.4 a
// junction breaks beyond a stretch of 0.2 m, with mu_d = 0.17 it trails at 0.085 m and 0.17 N. It
// always slips for 2 ms.
#pragma once

#include <memory>

#include "rupture/forces/interface_law.hpp"
#include "rupture/model/derived.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

inline constexpr double kRounding = 1e-15;

inline Parameters hand_made(std::int64_t N_s) {
  Parameters p;
  p.Nx = 1;
  p.N_s = N_s;
  p.kappa = 4.0;
  p.delta_t_R = 0.0;
  return p;
}

/// One block that is moved by hand over its junctions; f_N is the same on each.
class Interface {
 public:
  explicit Interface(const Parameters& p)
      : p_(p), junctions_(unstretched(p)), law_(make_law(p, junctions_)) {
    press(1.0);
  }
  Interface(const Interface&) = delete;

  void press(double f_N) {
    p_i_ = f_N * static_cast<double>(p_.N_s);
    k_ij_ = junction_stiffness(p_, 0, p_i_);
    w_ = f_N > 0.0 ? f_N / k_ij_ : 0.0;
  }
  /// The block comes to u at time t; its velocity has the sign of the way it came.
  InterfaceLaw::Changes move(double u, double t) {
    const double v = u - u_;
    u_ = u;
    return law_->update(&u_, &v, contact(), t);
  }
  double friction() {
    double tau = 0.0;
    law_->friction(&u_, contact(), &tau);
    return tau;
  }
  std::int32_t pinned() const { return law_->pinned()[0]; }
  Junctions& junctions() { return junctions_; }
  double attachment() const { return junctions_.attachment(0, 0); }

 private:
  static Junctions unstretched(const Parameters& p) { return State(p).junctions; }
  ContactView contact() { return {&p_i_, &k_ij_, &w_}; }

  const Parameters p_;
  Junctions junctions_;
  std::unique_ptr<InterfaceLaw> law_;
  double p_i_ = 0, k_ij_ = 0, w_ = 0, u_ = 0;
};

}  // namespace rupture::testing
