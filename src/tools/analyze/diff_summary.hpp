// What one asks of two files first: which parameters differ, whether they come from one file, and
// from where on they differ.
#pragma once

#include "cli/report.hpp"
#include "rupture/checkpoint/compare.hpp"

namespace rupture::tools {

/// What of two files counts in their checksums.
struct Pair {
  Content a, b;
};

/// {"a", "b"}: when the states are [s]; null of records. Throws Failure if they are no states.
Json times_json(const ContentFile& a, const ContentFile& b);

/// A line if the times differ, else nothing.
std::string times_text(const Json& times);

/// {"parameters", "ancestor", "first_sample"}: docs/schema.md. Throws Failure if parameters cannot
/// be read.
Json summary_json(const ContentFile& a, const ContentFile& b, const Pair& pair);

/// Three lines. `report` has these members, and those of the differences.
std::string summary_text(const Json& report);

}  // namespace rupture::tools
