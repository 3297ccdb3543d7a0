// analyze quantities: the names, units and meanings of parameters and of what is measured.
#include <fmt/core.h>

#include <vector>

#include "analyze/analyze.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "run/output.hpp"

namespace rupture::tools {
namespace {

const std::vector<const Command*> kWriters = {&load_command,    &restart_command,
                                              &prepare_command, &modify_phi_command,
                                              &finish_command,  &seal_command};

std::vector<NamedQuantity> quantities_of(const std::vector<const Command*>& commands) {
  std::vector<NamedQuantity> all;
  for (const Command* command : commands) {
    if (command->quantities == nullptr) continue;
    const std::string_view name = command->name();
    const auto reported =
        named(std::string(name.substr(name.find(' ') + 1)), command->quantities());
    all.insert(all.end(), reported.begin(), reported.end());
  }
  return all;
}

Json json_of(const std::vector<NamedQuantity>& quantities) {
  Json list = Json::array();
  for (const NamedQuantity& quantity : quantities) {
    list.push_back({{"name", quantity.name}, {"unit", quantity.unit}, {"help", quantity.help}});
  }
  return list;
}

void print_lines(const std::vector<NamedQuantity>& quantities) {
  for (const NamedQuantity& quantity : quantities) {
    const std::string unit = quantity.unit.empty() ? "" : "[" + quantity.unit + "]";
    say("  {:<58} {:<6} {}\n", quantity.name, unit, quantity.help);
  }
}

void print_text() {
  say("Parameters: name, default, unit, meaning (symbol)\n{}", parameter_help());
  say("\nQuantities: name (command, then field of its --json; * is an index), unit, "
      "meaning\n");
  print_lines(quantities_of(commands()));
  say("\nSummaries: name (program that writes files, then field of its --json), unit, meaning\n");
  print_lines(quantities_of(kWriters));
}

}  // namespace

constinit const Command quantities_command = {
    "analyze quantities",
    "",
    "names and units of all parameters and of all measured quantities",
    "Lists all parameters, and everything that the commands of analyze and the programs that\n"
    "write files report with --json.",
    {add_json_option},
    [](const Parsed& parsed) {
      if (parsed.values.count("json") > 0) {
        say("{}\n", json_text({{"parameters", tools::json_of(parameter_table())},
                               {"quantities", json_of(quantities_of(commands()))},
                               {"summaries", json_of(quantities_of(kWriters))}}));
      } else {
        print_text();
      }
      return int{kDone};
    }};

}  // namespace rupture::tools
