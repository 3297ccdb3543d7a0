// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// What makes a record's arrays named and labelled ones in other programs, such as xarray.
#pragma once

#include "hdf5_objects.hpp"
#include "rupture/checkpoint/content.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

/// Where the blocks of the interface are, one dataset for each group that needs it.
Content record_positions(const Parameters& parameters);

/// Labels of all datasets of a record that have any.
hdf5::Labels record_labels(const Content& record);

}  // namespace rupture
