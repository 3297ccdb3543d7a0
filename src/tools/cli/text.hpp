// Text that the tools show: numbers with units, lines without control characters.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rupture::tools {

/// Prints and never throws: run_tool() asks at the end whether all of standard output went out, so
/// that a full disk behind it cannot interrupt a run.
template <class... Args>
void say_on(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  std::fputs(fmt::format(format, std::forward<Args>(args)...).c_str(), stream);
}
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  say_on(stdout, format, std::forward<Args>(args)...);
}

/// The text of a file that a user wrote, without a byte order mark. Throws Failure, saying `what`
/// ("configuration file") in which form ("INI file") was expected, if it cannot be read, has more
/// than so many bytes, or is no UTF-8.
std::string text_of_file(const std::string& path, std::string_view what, std::string_view form,
                         std::size_t longest = 100'000);

std::vector<std::string> split(std::string text, char separator);

/// 6000000 as "6,000,000".
std::string grouped(double whole_number);

/// Two digits at least, no exponent.
std::string rounded(double value);

/// A duration [s] in the unit that suits it: "12 s", "3.4 h".
std::string time_text(double t);

/// The text with its control characters, also the two-byte ones of UTF-8, as question marks: what a
/// file or its name says may hold anything, also what a terminal or a shell obeys.
std::string in_one_line(std::string text);

}  // namespace rupture::tools
