// Small valid contents, which the fuzzer changes.
#pragma once

#include "rupture/checkpoint/checkpoint.hpp"

namespace rupture::fuzz {

/// 4 x 3 blocks with two junctions each.
inline Parameters small_parameters(Law law) {
  Parameters p;
  p.L = 0.015;
  p.H = 0.01;
  p.Nx = 4;
  p.Nz = 3;
  p.N_s = 2;
  p.law = law;
  return p;
}

inline std::vector<ProvenanceEntry> small_provenance() {
  return {{"load", "0.1.0", "abc", "load -o x.h5", "gcc 12.2.0", ""}};
}

inline Content checkpoint_content(Law law) {
  const Parameters p = small_parameters(law);
  State state(p);
  state.step = 1000;
  state.junctions.repin_time(1, 0) = law == Law::simplified ? Junctions::unknown : 1e-3;
  if (law == Law::simplified) state.junctions.slow_until(1, 0) = 1e-3;
  Content content = parameters_content(p);
  content.merge(state_content(state));
  content.merge(provenance_content(small_provenance()));
  return content;
}

inline Content record_content() {
  const Parameters p = small_parameters(Law::reference);
  Content content = parameters_content(p);
  content.merge(provenance_content(small_provenance()));
  const std::vector<double> times = {1e-4, 2e-4, 3e-4};
  const std::vector<std::int64_t> steps = {500, 1000, 1500};
  const std::vector<double> forces(12, 480.0);
  const std::vector<std::uint16_t> pinned(12, 2);
  content["/series/time"] = make_array(std::span(times), {3}, "s");
  content["/series/step"] = make_array(std::span(steps), {3}, "1");
  content["/series/F_T"] = make_array(std::span(times), {3}, "N");
  const std::vector<double> drive = {1e-4 * p.V, 2e-4 * p.V, 3e-4 * p.V};
  content["/series/x_drive"] = make_array(std::span(drive), {3}, "m");
  content["/series/pinned"] = make_array(std::span(pinned), {3, 4}, "1");
  content["/series/p"] = make_array(std::span(forces), {3, 4}, "N");
  content["/series/tau"] = make_array(std::span(forces), {3, 4}, "N");
  content["/series/u_x"] = make_array(std::span(forces), {3, 4}, "m");
  const std::vector<std::int64_t> blocks = {0, 1, 2};
  content["/ruptures/step"] = make_array(std::span(steps), {3}, "1");
  content["/ruptures/time"] = make_array(std::span(times), {3}, "s");
  content["/ruptures/block"] = make_array(std::span(blocks), {3}, "1");
  const std::vector<double> levels = {0.2, 0.5}, crossed = {0.5, 0.5, 0.2};
  content["/crossings/levels"] = make_array(std::span(levels), {2}, "1");
  content["/crossings/step"] = make_array(std::span(steps), {3}, "1");
  content["/crossings/time"] = make_array(std::span(times), {3}, "s");
  content["/crossings/block"] = make_array(std::span(blocks), {3}, "1");
  content["/crossings/pinned_below"] = make_array(std::span(crossed), {3}, "1");
  return content;
}

}  // namespace rupture::fuzz
