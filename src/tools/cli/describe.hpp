// A program's own description, for programs that call it: --describe.
#pragma once

#include "cli/command_line.hpp"
#include "cli/report.hpp"

namespace rupture::tools {

/// Name, purpose, input, outputs and options of a program or command (docs/schema.md). `options`
/// are all that it takes, with values of cli/option_values.hpp.
Json description(const ToolText& text, const po::options_description& options,
                 const std::string& positional, UsesParameters uses_parameters);

}  // namespace rupture::tools
