// The programs that `rupture` runs, and what they say of themselves.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/report.hpp"

namespace rupture::tools {

/// The names of the programs that are built and installed with this one, in the order of the help.
std::vector<std::string_view> tool_names();

/// The program of this name: in ../libexec/rupture if this one is installed, else beside it. Throws
/// Failure if one of tool_names() is not there, UsageError with the nearest of them for other
/// names.
std::filesystem::path tool_path(const std::string& name);

/// What each of tool_names() answers to --describe (docs/schema.md); of one that does not, only its
/// name.
Json tool_descriptions();

}  // namespace rupture::tools
