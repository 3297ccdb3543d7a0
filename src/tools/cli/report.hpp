// JSON as the programs print it: values of parameters, and what a program says of itself.
#pragma once

#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture::tools {

using Json = nlohmann::ordered_json;

/// The JSON in one line. Bytes that are no UTF-8, as file names may hold, become U+FFFD.
std::string json_text(const Json& json);

/// The value of a parameter: a number, or the word that was chosen.
Json json_of(const Parameters& parameters, const ParameterInfo& info);

Json json_of(const ProvenanceEntry& entry);

/// Everything about these parameters (docs/schema.md).
Json json_of(const std::vector<ParameterInfo>& rows);

/// Name, purpose, input, outputs and options of a program or command, for --describe
/// (docs/schema.md). `options` are all that it takes, with values of cli/option_values.hpp.
Json description(const Command& command, const po::options_description& options);

}  // namespace rupture::tools
