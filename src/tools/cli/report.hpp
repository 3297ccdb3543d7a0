// JSON as the programs print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/command_line.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture::tools {

using Json = nlohmann::ordered_json;

/// The JSON in one line. Bytes that are no UTF-8, as file names may hold, become U+FFFD.
std::string json_text(const Json& json);

/// The value of a parameter: a number, or the word that was chosen.
Json json_of(const Parameters& parameters, const ParameterInfo& info);

}  // namespace rupture::tools
