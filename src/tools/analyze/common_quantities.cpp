#include "analyze/common_quantities.hpp"

#include "rupture/model/derived.hpp"

namespace rupture::tools {

Quantity type_quantity(const Front& front) {
  return {"type", "", "none, arrested, slow or fast", std::string(front_type_name(front.type))};
}

Quantities kind_quantities(const Front& front) {
  return {
      type_quantity(front),
      {"reached_edge", "", "whether the block at the leading edge ruptured", front.reached_edge},
      {"fast_slow_fast", "",
       "whether it spans and is below c_s/10 over three stencils or more, with medians of at least "
       "c_s/10 before and after",
       front.fast_slow_fast},
      {"backward_stencils", "1", "stencils beyond the loading zone where the front runs backwards",
       static_cast<std::int64_t>(front.backward_stencils)},
  };
}

Quantity arrest_quantity(const Front& front) {
  return {"x_arrest", "m", "furthest ruptured block of an arrested front", front.x_arrest};
}

Quantity slow_quantity(const std::optional<SlowStretch>& slow) {
  const SlowStretch s = slow.value_or(SlowStretch{});
  const auto known = [&](double value) { return slow ? std::optional(value) : std::nullopt; };
  const Quantities rows = {
      {"x_from", "m", "first block of the slow stretch", known(s.x_from)},
      {"x_to", "m", "last block of the slow stretch", known(s.x_to)},
      {"t_from", "s", "time at which the slow stretch begins", known(s.t_from)},
      {"t_to", "s", "time at which the slow stretch ends", known(s.t_to)},
      {"duration", "s", "duration of the slow stretch", known(s.duration())},
      {"speed", "m/s", "median front speed in the slow stretch", known(s.speed)},
      {"slowest", "m/s", "smallest front speed in the slow stretch", known(s.slowest)},
      {"stencils", "1", "consecutive slow stencils", known(static_cast<double>(s.stencils))},
      {"mean", "m/s", "length of the slow stretch over its duration", s.mean()},
      {"fast_before", "m/s", "median front speed before the slow stretch", s.fast_before},
      {"fast_after", "m/s", "median front speed after the slow stretch", s.fast_after},
  };
  return {"slow", "", "", Group{rows, slow.has_value()}};
}

Quantity positions(Value x) {
  return {"x", "m", "position of each block", std::move(x), Csv::yes, TextColumn{9, "{:.4f}"}};
}

Quantity rupture_times(const RuptureLine& line) {
  return {"t_rupture", "s", "first rupture of each block", line.t_rupture};
}

Quantity shear_wave_quantity(const Parameters& parameters) {
  return {"c_s", "m/s", "speed of shear waves", shear_wave_speed(parameters)};
}

Quantity length_quantity(const Parameters& parameters) {
  return {"L", "m", "length of the interface", parameters.L};
}

Quantity load_quantity(double F_N) {
  return {"F_N", "N", "normal load", F_N};
}

Quantity text_only(Value value, const TextColumn& column) {
  return {"", "", "", std::move(value), Csv::no, column};
}

}  // namespace rupture::tools
