// What commands report of a front, in JSON, tables and words.
#pragma once

#include "analyze/chosen_event.hpp"

namespace rupture::tools {

/// Quantities that say what the window does not show of the event, and the sentences.
Quantities hidden_quantities(const Front& front, const EventEnd& end);
/// How far events are apart, where t_R varies much along the interface; else nothing.
std::string apart_text(const Parameters& p, double quiet);
std::string hidden_text(const Front& front, const EventEnd& end);

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
