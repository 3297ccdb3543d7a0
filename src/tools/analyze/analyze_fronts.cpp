// analyze front, classify: the front of one event in a record.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "analyze/event_choice.hpp"
#include "analyze/front_report.hpp"
#include "analyze/record_command.hpp"
#include "cli/text.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {

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

}  // namespace rupture::tools
