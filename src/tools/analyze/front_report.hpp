// What commands report of a front, in JSON, tables and words.
#pragma once

#include "analyze/chosen_event.hpp"

namespace rupture::tools {

/// What the window does not show of the event.
Quantities hidden_quantities(const Front& front, const EventEnd& end);
/// The sentences, of the first and last event in a record.
std::string events_text(const Parameters& p, const std::vector<Event>& events, double quiet);

Quantity type_quantity(const Front& front);
/// A slow stretch; null without one.
Quantity stretch_quantity(const std::string& key, const std::optional<SlowStretch>& slow);

/// The type, or fast-slow-fast.
std::string kind_name(const Front& front);

/// Where the front is below the limit that makes it of this kind. Places are centres of stencils.
std::string kind_text(const Front& front, double c_s);

/// The front as a whole: a line, and of a fast-slow-fast one another with its type.
std::string front_text(const Front& front, const Parameters& p, const ChosenEvent& event);

}  // namespace rupture::tools
