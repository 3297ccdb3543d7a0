// Rows that several commands report.
#pragma once

#include <optional>
#include <vector>

#include "cli/quantity.hpp"
#include "rupture/analysis/front.hpp"

namespace rupture::tools {

Quantity type_quantity(const Front& front);
Quantities kind_quantities(const Front& front);  ///< type, and what stands beside it
Quantity arrest_quantity(const Front& front);
Quantity slow_quantity(const std::optional<SlowStretch>& slow);  ///< null without a slow stretch
Quantity positions(Value x);  ///< of blocks, also in CSV and text
Quantity rupture_times(const RuptureLine& line);
Quantity shear_wave_quantity(const Parameters& parameters);
Quantity length_quantity(const Parameters& parameters);
Quantity load_quantity(double F_N);

/// A row that the table in the text shows, and nothing else.
Quantity text_only(Value value, const TextColumn& column);

}  // namespace rupture::tools
