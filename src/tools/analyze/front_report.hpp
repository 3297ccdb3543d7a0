// The report of a front that several commands give, and its criteria.
#pragma once

#include <string>

#include "analyze/event_choice.hpp"
#include "rupture/analysis/front.hpp"

namespace rupture::tools {

/// --slow-below, --skip-below-x, --stencil, --stencils-at-ends and --ruptured-below, by which
/// record_of() goes.
void add_criteria_options(po::options_description& options);

/// Throws UsageError for a criterion that this record cannot meet.
FrontCriteria criteria(const RecordCommand& command);

/// The front of the chosen event.
Front front_of(const RecordCommand& command, const ChosenEvent& event);

/// The type, or fast-slow-fast.
std::string kind_name(const Front& front);

std::string slow_text(const Front& front, double c_s);

/// One line on the front as a whole.
std::string front_text(const Front& front, double c_s, const ChosenEvent& event);

}  // namespace rupture::tools
