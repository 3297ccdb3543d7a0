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

/// {"parameters", "ancestor", "first_sample"}: docs/schema.md. Throws Failure if parameters cannot
/// be read.
Json summary_json(const ContentFile& a, const ContentFile& b, const Pair& pair);

/// Three lines. `report` has these members, and those of the differences.
std::string summary_text(const Json& report);

}  // namespace rupture::tools
