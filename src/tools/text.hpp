// Text that the tools show: parameter help, suggestions, aligned lines.
#pragma once

#include <boost/program_options.hpp>
#include <string>

namespace rupture::tools {

/// One line per parameter: name, symbol, default, unit, meaning.
std::string parameter_help();

/// "unknown option '--untill': did you mean '--until'? See load --help".
std::string unknown_option_text(const std::string& option,
                                const boost::program_options::options_description& known,
                                const std::string& tool);

}  // namespace rupture::tools
