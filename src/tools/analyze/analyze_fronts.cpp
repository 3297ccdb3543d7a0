// analyze front, classify: the front of one event in a record.
#include "analyze/analyze.hpp"
#include "analyze/common_quantities.hpp"
#include "analyze/event_choice.hpp"
#include "analyze/front_report.hpp"
#include "analyze/record_command.hpp"
#include "cli/text.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

Quantities classification_of(const Front& front) {
  return join({kind_quantities(front), {arrest_quantity(front)}});
}

Quantities quantities_of(const Front& front, const Parameters& p) {
  const TextColumn times = {17, "{:.7f}"}, speeds = {12, "{:.4g}"};
  const Quantities line = {
      positions(front.line.x),
      in_csv(rupture_times(front.line), times),
      {"v_c", "m/s", "front speed at each block", front.v_c, Csv::yes, speeds},
  };
  const Quantities slow = {
      slow_quantity(front.slow),
      shear_wave_quantity(p),
      length_quantity(p),
  };
  return join({line, classification_of(front), slow});
}

}  // namespace

Quantities front_quantities() {
  return quantities_of(Front{}, Parameters{});
}
Quantities classify_quantities() {
  return classification_of({});
}

int analyze_front(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_event_options(options);
  add_criteria_options(options);
  const auto command =
      read_record_command(argc, argv, "front",
                          "Rupture line, speed and type of one event's front: first rupture of "
                          "each block,\nv_c from the end points of a moving stencil. Of several "
                          "events one has to be\nchosen, but on a prepared interface the one that "
                          "the trigger started is meant.",
                          options);
  const ChosenEvent event = choose_event(command);
  const Front front = front_of(command, event);
  const Parameters& p = command.record.parameters;
  print(quantities_of(front, p), front_text(front, shear_wave_speed(p), event),
        command.parsed.values);
  return kDone;
}

int analyze_classify(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("json", "print one JSON object");
  add_event_options(options);
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "classify",
      "Prints what one event's front is: none (nothing ruptured), arrested, slow, fast or\n"
      "fast-slow-fast, and nothing else.",
      options);
  const Front front = front_of(command, choose_event(command));
  print(classification_of(front), kind_name(front) + "\n", command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
