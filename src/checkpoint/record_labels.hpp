// What makes a record's arrays named and labelled ones in other programs, such as xarray.
#pragma once

#include "hdf5_objects.hpp"
#include "rupture/checkpoint/content.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

/// Where the blocks are: datasets for the groups of `record` that need them.
Content record_positions(const Parameters& parameters, const Content& record);

/// Labels of all datasets of a record that have any.
hdf5::Labels record_labels(const Content& record);

}  // namespace rupture
