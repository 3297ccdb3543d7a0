// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Text that the tools show: parameter help, suggestions, aligned lines.
#pragma once

#include <fmt/format.h>

#include <boost/program_options.hpp>
#include <cstdio>
#include <string>
#include <utility>

namespace rupture::tools {

/// Prints to standard output and never throws: run_tool() asks at the end whether all went out, so
/// that a full disk behind standard output cannot interrupt a run.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(fmt::format(format, std::forward<Args>(args)...).c_str(), stdout);
}

/// One line per parameter: name, symbol, default, unit, meaning.
std::string parameter_help();

/// "unknown option '--untill': did you mean '--until'? See rupture load --help".
std::string unknown_option_text(const std::string& option,
                                const boost::program_options::options_description& known,
                                const std::string& tool);

/// The text with its control characters as question marks: what a file or its name says may hold
/// anything, also what a terminal or a shell obeys.
std::string in_one_line(std::string text);

}  // namespace rupture::tools
