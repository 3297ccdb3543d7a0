// Parameters as datasets, and how they count in the content checksum.
#pragma once

#include "rupture/checkpoint/content.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

/// The parameters as datasets: row "slider.L" of the table becomes /parameters/slider/L.
Content parameters_content(const Parameters& parameters);

/// The parameters of a content as they count in its checksum (docs/schema.md): one that the law
/// does not use with its default, and one of Since::later only where it differs from that. Other
/// tables than that of this build are for tests.
Content counted_parameters(const Content& content,
                           const std::vector<ParameterInfo>& table = parameter_table());

/// Throws Failure if the content has a parameter that this build does not know.
void refuse_unknown_parameters(const Content& content);

/// Throws Failure if a parameter is missing, unknown or out of range, or if they contradict each
/// other. Parameters that older builds did not have may be missing: they take their default, which
/// is how those builds behaved.
Parameters read_parameters(const Content& content);

}  // namespace rupture
