// Small sliders for tests, and what the tests do with them.
#pragma once

#include <random>
#include <string>

#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/plain_step.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::testing {

/// Nx x Nz blocks, each with the size, mass, stiffness and load of a block of the reference slider,
/// driven at the second row.
inline Parameters small_slider(std::int64_t Nx, std::int64_t Nz) {
  const Parameters reference;
  const double l = block_spacing(reference);
  Parameters p;
  p.Nx = Nx;
  p.Nz = Nz;
  p.L = static_cast<double>(Nx - 1) * l;
  p.H = static_cast<double>(Nz - 1) * l;
  p.M = static_cast<double>(Nx * Nz) * block_mass(reference);
  p.F_N = static_cast<double>(Nx) * mean_normal_force(reference);
  p.h = l;
  return p;
}

/// With the other springs along the faces and the other dampers.
inline Parameters with_other_bulk(Parameters p) {
  p.edge_springs = EdgeSprings::half;
  p.damping_along = DampingAlong::spring;
  return p;
}

/// Driven so fast that the whole interface ruptures 0.28 ms (1,400 steps) after the start, and is
/// pinned again soon after.
inline Parameters quick_slider() {
  Parameters p = small_slider(9, 5);
  p.V = 0.1;
  p.t_R = 0.1e-3;
  p.delta_t_R = 0.03e-3;
  return p;
}

/// The quick slider under another interface law; the decaying one with the parameters of Fig. S6.
inline Parameters quick_slider(Law law) {
  Parameters p = quick_slider();
  p.law = law;
  if (law == Law::decaying) {
    p.kappa = 54.1e9;
    p.mu_d = 0.28;
    p.mu_new = 0.196;
  }
  return p;
}

/// For the names of parameterised tests.
inline std::string law_name(Law law) {
  Parameters p;
  p.law = law;
  return parameter_text(p, find_parameter("junctions.law"));
}

inline constexpr Law kAllLaws[] = {Law::reference, Law::simplified, Law::decaying, Law::distance};

/// The quick slider under a ceiling and at rest, with a prestress whose trigger region of three
/// blocks lets the rest rupture within 0.05 ms.
inline Parameters prepared_slider() {
  Parameters p = quick_slider();
  p.support = Support::ceiling;
  p.V = 0.0;
  return p;
}
inline Prestress quick_prestress() {
  return {0.6, 0.15, PhiShape::uniform, 2.5 * block_spacing(prepared_slider())};
}

/// A plate without driving, damping or (but for 1e-9 N, as zero is no valid load) any load.
inline Parameters free_plate(std::int64_t Nx, std::int64_t Nz) {
  Parameters p = small_slider(Nx, Nz);
  p.F_N = 1e-9;
  p.K = 0.0;
  p.damping = 0.0;
  return p;
}

/// The plate at rest 1 mm above the track, out of reach of foundation and junctions.
inline State lifted(const Parameters& p) {
  State state(p);
  state.u_z.blocks() = 1e-3;
  return state;
}

/// Reproducible numbers, uniform in [-size, size].
class Noise {
 public:
  explicit Noise(double size) : numbers_(-size, size) {}
  double operator()() { return numbers_(engine_); }
  void fill(Field& field) {
    for (Eigen::Index j = 0; j < field.Nz(); ++j) {
      for (Eigen::Index i = 0; i < field.Nx(); ++i) field(i, j) = (*this)();
    }
  }

 private:
  std::mt19937_64 engine_{20140616};
  std::uniform_real_distribution<double> numbers_;
};

/// The message of the `Error` that `work` throws; a note that it threw none otherwise.
template <class Error, class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "(nothing was thrown)";
}

}  // namespace rupture::testing
