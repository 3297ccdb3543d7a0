// The energy account of a run: what came in, where it is, where it went.
#pragma once

namespace rupture {

/// Energy stored in the slider and its boundaries at one instant [J].
struct Energies {
  double kinetic = 0;
  double bulk = 0;     ///< springs between blocks
  double contact = 0;  ///< elastic foundation or ceiling, 1/2 k_f u_z^2 where pressed
  double driving = 0;  ///< driving spring, 1/2 K (x_drive - u_x)^2
  double load = 0;     ///< potential of F_N, sum of (F_N / N_x) u_z over the top row; under a
                       ///< ceiling of -(F_N / N_x) u_z over the bottom row

  double total() const { return kinetic + bulk + contact + driving + load; }
};

/// Power of each force that does not conserve energy, at one instant [W].
struct Power {
  double driving = 0;    ///< F_T V, into the system
  double damping = 0;    ///< bulk damping and the support's dashpots, out of the system
  double junctions = 0;  ///< against the junctions, out of the system
};

/// Work of the same forces over some time [J].
struct Work {
  double driving = 0;
  double damping = 0;
  double junctions = 0;

  Work& operator+=(const Work& more);
};

Work operator-(const Work& a, const Work& b);

/// Work done in a step of length dt [s], by the trapezoidal rule, which is how velocity Verlet
/// itself adds up work.
Work integrate(const Power& before, const Power& now, double dt);

/// The account of a run [J].
struct EnergyBalance {
  double supplied = 0;   ///< work of the driving point and of F_N
  double stored = 0;     ///< gain of kinetic, bulk, contact and driving-spring energy
  double damping = 0;    ///< energy that damping took
  double junctions = 0;  ///< work done against the junctions, of which pinned ones can give a part
                         ///< back: it may fall, and be negative

  double taken() const { return damping + junctions; }
  double error() const { return supplied - stored - taken(); }
  /// |error| relative to the largest of the three terms and of `least_scale` [J]; 0 if all are.
  double relative_error(double least_scale = 0.0) const;
};

EnergyBalance energy_balance(const Energies& before, const Energies& after, const Work& work);

}  // namespace rupture
