#include "analyze/front_report.hpp"

#include <fmt/core.h>

#include "cli/option_values.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {

namespace {

/// Only a stencil that was asked for has to fit: a short interface has no speeds by default.
std::size_t stencil(const po::variables_map& values, const Parameters& p) {
  const int blocks = values["stencil"].as<int>();
  if (blocks < 3 || blocks % 2 == 0) {
    throw UsageError(
        fmt::format("--stencil must be an odd number of blocks, 3 or more (got {})", blocks));
  }
  if (blocks > p.Nx && !values["stencil"].defaulted()) {
    throw UsageError(fmt::format("--stencil {} is longer than the interface, which has {} blocks",
                                 blocks, p.Nx));
  }
  return static_cast<std::size_t>(blocks);
}

double skip_below_x(const po::variables_map& values, const Parameters& p) {
  const double x = non_negative(values, "skip-below-x");
  if (x <= p.L || values["skip-below-x"].defaulted()) return x;
  throw UsageError(
      fmt::format("--skip-below-x {:g} is beyond the interface, which ends at {:g} m", x, p.L));
}

StencilsAtEnds stencils_at_ends(const po::variables_map& values) {
  const auto& name = values["stencils-at-ends"].as<std::string>();
  if (name == "slow") return StencilsAtEnds::slow;
  return name == "fast" ? StencilsAtEnds::fast : StencilsAtEnds::neither;
}

}  // namespace

void add_criteria_options(po::options_description& options) {
  auto add = options.add_options();
  add("slow-below", number("R")->default_value(0.05, "0.05"),
      "the front is slow where |v_c| < R c_s");
  add("skip-below-x", number("X", "m")->default_value(kLoadingZone, "0.02"),
      "end of the loading zone, in which blocks and speeds do not count");
  add("stencil", integer("N")->default_value(5),
      "odd number of blocks of the stencil whose end points give v_c");
  add("stencils-at-ends", one_of("neither|slow|fast")->default_value("neither"),
      "whether stencils that touch both the slow stretch and its surroundings count to neither, to "
      "the slow stretch, or to the fast sides");
  add("ruptured-below", number("F")->default_value(kRupturedFraction, "0.3"),
      "pinned fraction below which a block counts as ruptured: 0.3, or one of the record's "
      "--crossings");
}

FrontCriteria criteria(const RecordCommand& command) {
  const po::variables_map& values = command.values;
  const Parameters& p = command.record.parameters;
  return {.slow_below = non_negative(values, "slow-below"),
          .skip_below_x = skip_below_x(values, p),
          .stencil = stencil(values, p),
          .stencils_at_ends = stencils_at_ends(values)};
}

Front front_of(const RecordCommand& command, const ChosenEvent& event) {
  const Parameters& p = command.record.parameters;
  return measure_front(p, rupture_line(p, event.ruptures, event.from, event.to), criteria(command));
}

std::string kind_name(const Front& front) {
  return front.fast_slow_fast ? "fast-slow-fast" : std::string(front_type_name(front.type));
}

std::string slow_text(const Front& front, double c_s) {
  const auto& slow = front.slow;
  if (front.fast_slow_fast && front.type == FrontType::fast) {
    return "below c_s/10, but not below --slow-below";
  }
  if (!slow && front.type == FrontType::slow) return "slow for less than a stencil";
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
      event.in_window > 1
          ? fmt::format("; event {} of {}, started by the trigger (see analyze events)",
                        event.number, event.in_window)
          : "";
  return fmt::format("{} front; {}{}\n", kind_name(front), slow_text(front, c_s), others);
}

}  // namespace rupture::tools
