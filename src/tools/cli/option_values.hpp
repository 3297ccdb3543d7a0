// Numbers that options give: times, lengths and the like.
#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rupture::tools {

namespace po = boost::program_options;

/// Times in seconds that an option gives. They are read as text, so that "10ms" gets a sentence of
/// its own. Throws UsageError unless they are numbers; but they may be negative or not finite.
std::vector<double> times(const po::variables_map& values, const std::string& option);

/// One such time. Throws UsageError unless it is finite and >= 0.
double time_from_zero(const po::variables_map& values, const std::string& option);
std::optional<double> optional_time(const po::variables_map& values, const std::string& option);

/// The value of a length or similar option. Throws UsageError unless it is finite and >= 0.
double non_negative(const po::variables_map& values, const std::string& option);
double non_negative(double value, const std::string& option);
std::optional<double> optional_non_negative(const po::variables_map& values,
                                            const std::string& option);

}  // namespace rupture::tools
