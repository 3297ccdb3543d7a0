#include "analyze/front_report.hpp"

#include <fmt/core.h>

#include "cli/option_values.hpp"

namespace rupture::tools {

void add_criteria_options(po::options_description& options) {
  auto add = options.add_options();
  add("slow-below", number("R")->default_value(0.05, "0.05"),
      "the front is slow where v_c < R c_s");
  add("skip-below-x", number("X", "m")->default_value(0.02, "0.02"),
      "loading zone in which speeds do not count");
}

FrontCriteria criteria(const po::variables_map& values) {
  return {non_negative(values, "slow-below"), non_negative(values, "skip-below-x")};
}

Front front_of(const RecordCommand& command, const ChosenEvent& event) {
  const Parameters& p = command.record.parameters;
  return measure_front(p, rupture_line(p, event.ruptures, event.from, event.to),
                       criteria(command.parsed.values));
}

std::string slow_text(const std::optional<SlowStretch>& slow, double c_s) {
  if (!slow) return "no slow stretch";
  return fmt::format("slow from x = {:.4f} m to {:.4f} m for {:.3g} ms at {:.3g} m/s (c_s/{:.0f})",
                     slow->x_from, slow->x_to, slow->duration() * 1e3, slow->speed,
                     c_s / slow->speed);
}

std::string front_text(const Front& front, double c_s, const ChosenEvent& event) {
  if (front.type == FrontType::none) {
    return fmt::format("no front: nothing ruptured from t = {:.7g} s to {:.7g} s\n", event.from,
                       event.to);
  }
  const std::string others =
      event.in_window > 1 ? fmt::format("; event {}, the trigger's, of {} (see analyze events)",
                                        event.number, event.in_window)
                          : "";
  return fmt::format("{} front; {}{}\n", front_type_name(front.type), slow_text(front.slow, c_s),
                     others);
}

}  // namespace rupture::tools
