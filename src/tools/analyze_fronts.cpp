// analyze events, front, classify, slow-slip: the fronts in a record and the slip behind them.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analyze.hpp"
#include "event_choice.hpp"
#include "option_values.hpp"
#include "record_command.hpp"
#include "rupture/analysis/events.hpp"
#include "rupture/analysis/slip.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "text.hpp"

namespace rupture::tools {
namespace {

void add_criteria_options(po::options_description& options) {
  auto add = options.add_options();
  add("slow-below", po::value<double>()->default_value(0.05, "0.05")->value_name("R"),
      "the front is slow where v_c < R c_s");
  add("skip-below-x", po::value<double>()->default_value(0.02, "0.02")->value_name("X"),
      "loading zone in which speeds do not count [m]");
}

FrontCriteria criteria(const po::variables_map& values) {
  return {non_negative(values, "slow-below"), non_negative(values, "skip-below-x")};
}

Json slow_json(const std::optional<SlowStretch>& slow) {
  if (!slow) return nullptr;
  return {{"x_from", slow->x_from},
          {"x_to", slow->x_to},
          {"t_from", slow->t_from},
          {"t_to", slow->t_to},
          {"duration", slow->duration()},
          {"speed", slow->speed},
          {"fast_before", json_of(slow->fast_before)},
          {"fast_after", json_of(slow->fast_after)}};
}

std::string slow_text(const std::optional<SlowStretch>& slow, double c_s) {
  if (!slow) return "no slow stretch";
  return fmt::format("slow from x = {:.4f} m to {:.4f} m for {:.3g} ms at {:.3g} m/s (c_s/{:.0f})",
                     slow->x_from, slow->x_to, slow->duration() * 1e3, slow->speed,
                     c_s / slow->speed);
}

Json event_json(const Parameters& p, const Event& event, std::size_t number) {
  return {{"number", number},
          {"t_start", event.t_start},
          {"t_end", event.t_end},
          {"x_first", event.x_first},
          {"x_last", event.x_last},
          {"spanning", spans(event.front.type)},
          {"type", front_type_name(event.front.type)},
          {"slow", slow_json(event.front.slow)},
          {"F_T_before", event.F_T_before},
          {"F_T_after", event.F_T_after},
          {"c_s", shear_wave_speed(p)},
          {"L", p.L},
          {"t_rupture", json_of(event.front.line.t_rupture)}};
}

Front front_of(const RecordCommand& command, const ChosenEvent& event) {
  const Parameters& p = command.record.parameters;
  return measure_front(p, rupture_line(p, event.ruptures, event.from, event.to),
                       criteria(command.parsed.values));
}

/// What --csv prints of an event: names as in the JSON, with units.
constexpr std::array kEventColumns = {"number",
                                      "t_start [s]",
                                      "t_end [s]",
                                      "x_first [m]",
                                      "x_last [m]",
                                      "spanning",
                                      "type",
                                      "slow.x_from [m]",
                                      "slow.x_to [m]",
                                      "slow.t_from [s]",
                                      "slow.t_to [s]",
                                      "slow.duration [s]",
                                      "slow.speed [m/s]",
                                      "slow.fast_before [m/s]",
                                      "slow.fast_after [m/s]",
                                      "F_T_before [N]",
                                      "F_T_after [N]"};

/// Where a column's value is in the JSON of an event: "slow.x_from [m]" is /slow/x_from.
Json::json_pointer place_of(std::string heading) {
  heading.resize(std::min(heading.find(" ["), heading.size()));
  std::replace(heading.begin(), heading.end(), '.', '/');
  return Json::json_pointer("/" + heading);
}

void append(Column& column, const Json& value) {
  if (value.is_string()) {
    column.texts.push_back(value);
  } else if (value.is_boolean()) {
    column.texts.push_back(value.dump());
  } else {
    column.values.push_back(value.is_null() ? std::nullopt : std::optional<double>(value));
  }
}

std::vector<Column> event_columns(const Json& events) {
  std::vector<Column> columns;
  for (const char* const heading : kEventColumns) {
    Column column = {heading, {}};
    const auto place = place_of(heading);
    for (const Json& event : events) {
      append(column, event.contains(place) ? event.at(place) : Json());
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

/// One line on the front as a whole.
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

SlowSlipCriteria slow_slip_criteria(const po::variables_map& values) {
  return {non_negative(values, "longest"), non_negative(values, "shortest")};
}

/// The blocks between --x-from and --x-to, or those well inside the slow stretch.
std::vector<std::size_t> chosen_blocks(const Front& front, const po::variables_map& values) {
  const auto from = optional_non_negative(values, "x-from");
  const auto to = optional_non_negative(values, "x-to");
  if (!from && !to) return blocks_well_inside(front);
  const double half = 0.5 * front.line.x[1];
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    const double x = front.line.x[i];
    if (x > from.value_or(0.0) - half && x < to.value_or(x) + half) blocks.push_back(i);
  }
  if (blocks.empty()) throw UsageError("there is no block between --x-from and --x-to");
  return blocks;
}

/// What is known of the slow slip of several blocks, one value per block.
struct SlowSlips {
  std::vector<double> x, t_from, t_to, speed, r_squared, estimate;
  std::vector<std::optional<double>> v_c;
};

SlowSlips measure_slow_slips(const Record& record, const Front& front,
                             const std::vector<std::size_t>& blocks,
                             const SlowSlipCriteria& criteria) {
  const Parameters& p = record.parameters;
  SlowSlips slips;
  for (const std::size_t block : blocks) {
    const auto time = slow_slip_time(p, front, block, criteria);
    if (!time) continue;
    const auto column = static_cast<Eigen::Index>(block);
    std::vector<double> u_x;
    for (Eigen::Index n = 0; n < record.u_x.rows(); ++n) u_x.push_back(record.u_x(n, column));
    const auto line = fit_slow_slip({record.time, u_x}, *time);
    if (!line) continue;
    const auto first = std::lower_bound(record.time.begin(), record.time.end(), time->from);
    slips.x.push_back(front.line.x[block]);
    slips.t_from.push_back(time->from);
    slips.t_to.push_back(time->to);
    slips.speed.push_back(line->slope);
    slips.r_squared.push_back(line->r_squared);
    slips.estimate.push_back(
        slow_slip_estimate(p, record.p(std::distance(record.time.begin(), first), column)));
    slips.v_c.push_back(front.v_c[block]);
  }
  return slips;
}

std::optional<double> average(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> median_of_known(const std::vector<std::optional<double>>& values) {
  std::vector<double> known;
  for (const auto& value : values) {
    if (value) known.push_back(*value);
  }
  return median(known);
}

Json extremes_json(const std::vector<double>& values) {
  if (values.empty()) return {{"mean", nullptr}, {"min", nullptr}, {"max", nullptr}};
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return {{"mean", *average(values)}, {"min", *least}, {"max", *largest}};
}

}  // namespace

int analyze_events(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_quiet_time_option(options);
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "events", "Splits the block ruptures of a record into events, numbered from 0.",
      options);
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  const auto events = find_events(p, record.ruptures, {record.time, record.F_T},
                                  quiet_time(command), criteria(command.parsed.values));
  Report report;
  report.json = {{"events", Json::array()}};
  report.text = "number  t_start [s]    t_end [s]  reaches x [m]      type   drop of F_T [N]\n";
  for (std::size_t n = 0; n < events.size(); ++n) {
    const Event& event = events[n];
    report.json["events"].push_back(event_json(p, event, n));
    report.text += fmt::format(
        "{:6}{:13.7f}{:13.7f}{:15.4f}{:>10}{:18.1f}   {}\n", n, event.t_start, event.t_end,
        event.x_last, front_type_name(event.front.type), event.F_T_before - event.F_T_after,
        slow_text(event.front.slow, shear_wave_speed(p)));
  }
  report.series = event_columns(report.json["events"]);
  print(report, command.parsed.values);
  return kDone;
}

int analyze_front(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_event_options(options);
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "front",
      "Rupture line, speed and type of one event's front: first rupture of "
      "each block,\nv_c from the end points of a five-block stencil. Of several "
      "events one has to be\nchosen, but on a prepared interface the one that "
      "the trigger started is meant.",
      options);
  const ChosenEvent event = choose_event(command);
  const Front front = front_of(command, event);
  const double c_s = shear_wave_speed(command.record.parameters);
  Report report;
  report.json = {{"x", front.line.x},
                 {"t_rupture", json_of(front.line.t_rupture)},
                 {"v_c", json_of(front.v_c)},
                 {"type", front_type_name(front.type)},
                 {"x_arrest", json_of(front.x_arrest)},
                 {"slow", slow_json(front.slow)},
                 {"c_s", c_s},
                 {"L", command.record.parameters.L}};
  report.series = {column("x [m]", front.line.x),
                   {"t_rupture [s]", front.line.t_rupture},
                   {"v_c [m/s]", front.v_c}};
  report.text = "    x [m]    t_rupture [s]   v_c [m/s]\n";
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    const auto& t = front.line.t_rupture[i];
    report.text += fmt::format("{:9.4f}{:>17}{:>12}\n", front.line.x[i],
                               t ? fmt::format("{:.7f}", *t) : "-", text_of(front.v_c[i]));
  }
  report.text += front_text(front, c_s, event);
  print(report, command.parsed.values);
  return kDone;
}

int analyze_classify(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("json", "print one JSON object");
  add_event_options(options);
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "classify",
      "Prints the type of one event's front: none (nothing ruptured), arrested, "
      "slow or fast,\nand nothing else.",
      options);
  const Front front = front_of(command, choose_event(command));
  Report report;
  report.text = fmt::format("{}\n", front_type_name(front.type));
  report.json = {{"type", front_type_name(front.type)}, {"x_arrest", json_of(front.x_arrest)}};
  print(report, command.parsed.values);
  return kDone;
}

int analyze_slow_slip(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_event_options(options);
  add_criteria_options(options);
  auto add = options.add_options();
  add("x-from", po::value<double>()->value_name("X"),
      "blocks from here on, instead of those well inside the slow stretch [m]");
  add("x-to", po::value<double>()->value_name("X"), "blocks up to here [m]");
  add("longest", po::value<double>()->default_value(1.0, "1")->value_name("W"),
      "the slip of a block is followed for W <t_R> at most");
  add("shortest", po::value<double>()->default_value(0.5, "0.5")->value_name("W"),
      "blocks whose slip can be followed for less than W <t_R> are left out");
  const auto command = read_record_command(
      argc, argv, "slow-slip",
      "Slip speed of blocks while the front ahead of them is slow. Their slow slip begins H/c_s\n"
      "after their rupture, or after the front became slow, and is followed until the front "
      "leaves\n"
      "its slow stretch. The speed is that between 20 % and 80 % of this slip.",
      options);
  const ChosenEvent event = choose_event(command);
  const Front front = front_of(command, event);
  const SlowSlips slips =
      measure_slow_slips(command.record, front, chosen_blocks(front, command.parsed.values),
                         slow_slip_criteria(command.parsed.values));
  const auto front_speed = median_of_known(slips.v_c);
  const auto estimate = average(slips.estimate), speed = average(slips.speed);

  Report report;
  report.json = {{"type", front_type_name(front.type)},
                 {"slow", slow_json(front.slow)},
                 {"blocks", slips.x.size()},
                 {"front_speed", json_of(front_speed)},
                 {"speed", extremes_json(slips.speed)},
                 {"estimate", json_of(estimate)},
                 {"per_block",
                  {{"x", slips.x},
                   {"t_from", slips.t_from},
                   {"t_to", slips.t_to},
                   {"speed", slips.speed},
                   {"r_squared", slips.r_squared},
                   {"v_c", json_of(slips.v_c)},
                   {"estimate", slips.estimate}}}};
  report.series = {column("x [m]", slips.x),
                   column("t_from [s]", slips.t_from),
                   column("t_to [s]", slips.t_to),
                   column("speed [m/s]", slips.speed),
                   column("R^2", slips.r_squared),
                   {"v_c [m/s]", slips.v_c},
                   column("estimate [m/s]", slips.estimate)};
  report.text = "    x [m]   t_from [s]     t_to [s]   slip [mm/s]       R^2   v_c [m/s]\n";
  for (std::size_t i = 0; i < slips.x.size(); ++i) {
    report.text +=
        fmt::format("{:9.4f}{:13.7f}{:13.7f}{:14.4f}{:10.4f}{:>12}\n", slips.x[i], slips.t_from[i],
                    slips.t_to[i], slips.speed[i] * 1e3, slips.r_squared[i], text_of(slips.v_c[i]));
  }
  report.text += fmt::format(
      "{} blocks slip at {} mm/s on average (Eq. S1: {} mm/s); front: {} m/s\n", slips.x.size(),
      text_of(speed, 1e-3), text_of(estimate, 1e-3), text_of(front_speed));
  if (front.type == FrontType::none || event.in_window > 1) {
    report.text += front_text(front, shear_wave_speed(command.record.parameters), event);
  }
  print(report, command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
