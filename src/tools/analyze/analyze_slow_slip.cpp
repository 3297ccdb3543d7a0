// analyze slow-slip: the slip behind a slow front.
#include <fmt/core.h>

#include <algorithm>

#include "analyze/analyze.hpp"
#include "analyze/front_report.hpp"
#include "rupture/analysis/slip.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

SlowSlipCriteria slow_slip_criteria(const po::variables_map& values) {
  const double longest = non_negative(values, "longest"),
               shortest = non_negative(values, "shortest");
  if (longest < shortest) {
    throw UsageError("--longest must be at least --shortest, {:g} (got {:g})", shortest, longest);
  }
  return {longest, shortest};
}

/// The blocks between --x-from and --x-to, or those of the slow stretch.
std::vector<std::size_t> chosen_blocks(const Front& front, const po::variables_map& values) {
  const auto from = optional_non_negative(values, "x-from");
  const auto to = optional_non_negative(values, "x-to");
  if (!from && !to) return slow_blocks(front);
  const double half = 0.5 * front.line.x[1];
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    const double x = front.line.x[i];
    if (x > from.value_or(0.0) - half && x < to.value_or(x) + half) blocks.push_back(i);
  }
  if (blocks.empty())
    throw UsageError("no block lies between --x-from and --x-to: widen the range");
  return blocks;
}

/// The slow slip of one block.
struct SlowSlip {
  double x, t_from, t_to, speed, r_squared, estimate;
  std::optional<double> v_c;
};

std::vector<SlowSlip> measure_slow_slips(const Record& record, const Front& front,
                                         const std::vector<std::size_t>& blocks,
                                         const SlowSlipCriteria& criteria) {
  const Parameters& p = record.parameters;
  std::vector<SlowSlip> slips;
  for (const std::size_t block : blocks) {
    const auto time = slow_slip_time(p, front, block, criteria);
    if (!time) continue;
    const auto column = static_cast<Eigen::Index>(block);
    const auto moved = record.u_x.col(column);
    const std::vector<double> u_x(moved.begin(), moved.end());
    const auto line = fit_slow_slip({record.time, u_x}, *time);
    if (!line) continue;
    const auto first = std::ranges::lower_bound(record.time, time->from) - record.time.begin();
    const double estimate = slow_slip_estimate(p, column, record.p(first, column));
    slips.push_back({front.line.x[block], time->from, time->to, line->slope, line->r_squared,
                     estimate, front.v_c[block]});
  }
  return slips;
}

std::optional<double> average(const Numbers& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const auto& value : values) sum += *value;
  return sum / static_cast<double>(values.size());
}

/// Speeds of the stencils that run forwards.
std::optional<double> median_speed(const std::vector<SlowSlip>& slips) {
  std::vector<double> known;
  for (const SlowSlip& slip : slips) {
    if (slip.v_c && *slip.v_c > 0.0) known.push_back(*slip.v_c);
  }
  return median(known);
}

/// "-" where there is no speed [m/s].
std::string in_unit_of(double unit, const std::optional<double>& speed) {
  return speed ? fmt::format("{:.4g}", *speed / unit) : "-";
}

Report report_of(const Front& front, const std::vector<SlowSlip>& slips) {
  using S = SlowSlip;
  const Numbers speeds = each(slips, &S::speed), estimates = each(slips, &S::estimate);
  const bool none = slips.empty();
  const Quantities speed = {
      {"mean", "m/s", "mean of their speeds of slow slip", average(speeds)},
      {"min", "m/s", "smallest of their speeds of slow slip",
       none ? std::nullopt : std::ranges::min(speeds)},
      {"max", "m/s", "largest of their speeds of slow slip",
       none ? std::nullopt : std::ranges::max(speeds)},
  };
  const TextColumn times = {13, "{:.7f}"}, fit = {10, "{:.4f}"}, front_speeds = {12, "{:.4g}"},
                   slip = {14, "{:.4f}", "slip [mm/s]", 1e3};
  const Quantities per_block = {
      positions(each(slips, &S::x)),
      {"t_from", "s", "start of the fit at each block", each(slips, &S::t_from), Csv::yes, times},
      {"t_to", "s", "end of the fit at each block", each(slips, &S::t_to), Csv::yes, times},
      {"speed", "m/s", "speed of slow slip of each block", speeds, Csv::yes, slip},
      {"r_squared", "1", "R^2 of the fit at each block", each(slips, &S::r_squared), Csv::yes, fit,
       "R^2"},
      {"v_c", "m/s", "front speed at each block", each(slips, &S::v_c), Csv::yes, front_speeds},
      {"estimate", "m/s", "Eq. S1 at the normal force on each block", estimates, Csv::yes},
  };
  const auto front_speed = median_speed(slips), estimate = average(estimates);
  const Quantities rows = {
      type_quantity(front),
      stretch_quantity("slow", front.slow),
      {"blocks", "1", "blocks whose slow slip was measured", std::ssize(slips)},
      {"front_speed", "m/s", "median front speed at these blocks", front_speed},
      {"speed", "", "", Group{speed}},
      {"estimate", "m/s", "mean of Eq. S1 at their normal forces", estimate},
      {"per_block", "", "", Group{per_block}},
      criteria_quantity(front.criteria),
  };
  if (none) return {rows, "no block has slow slip that can be measured\n"};
  return {rows,
          fmt::format("{} block{}, mean slip speed {} mm/s (Eq. S1: {} mm/s); front: {} m/s\n",
                      slips.size(), slips.size() == 1 ? "" : "s", in_unit_of(1e-3, average(speeds)),
                      in_unit_of(1e-3, estimate), in_unit_of(1.0, front_speed))};
}

void add_slow_slip_options(po::options_description& options) {
  auto add = options.add_options();
  add("x-from", number("X", "m"), "blocks from this x on, instead of those of the slow stretch");
  add("x-to", number("X", "m"), "blocks up to this x");
  add("longest", number("W")->default_value(1.0, "1"),
      "follow the slip of a block for at most W <t_R>");
  add("shortest", number("W")->default_value(0.5, "0.5"),
      "leave out blocks whose slip can be followed for less than W <t_R>");
}

}  // namespace

constinit const Command slow_slip_command = {
    "analyze slow-slip RECORD",
    "record",
    "slip speed of the blocks behind the slow front in a record",
    "Slip speed of blocks while the front ahead of them is slow. Their slow slip begins H/c_s\n"
    "after their rupture, or after the front became slow, and is followed until the front leaves\n"
    "its slow stretch. The speed is measured between 20 % and 80 % of this slip.",
    {add_format_options, add_event_options, add_criteria_options, add_slow_slip_options},
    [](const Parsed& parsed) {
      const RecordCommand command = record_of(parsed);
      const ChosenEvent event = choose_event(command);
      const Front front = front_of(command, event);
      const auto slips =
          measure_slow_slips(command.record, front, chosen_blocks(front, parsed.values),
                             slow_slip_criteria(parsed.values));
      Report report = report_of(front, slips);
      if (front.type == FrontType::none || event.in_window > 1) {
        report.closing += front_text(front, command.record.parameters, event);
      }
      return print(report, parsed.values);
    },
    [] { return report_of({}, {}).rows; }};

}  // namespace rupture::tools
