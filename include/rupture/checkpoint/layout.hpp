// Which datasets there are: the tables by which files are written, as docs/schema.md prints them.
#pragma once

#include "rupture/checkpoint/content.hpp"

namespace rupture {

struct DatasetInfo {
  std::string path;       ///< with * for the number of a step of the provenance
  std::string_view type;  ///< "float64"
  std::string lengths;    ///< "[Nx][S]"; empty: a scalar. "|[Nx]": or an array, where it varies
  std::string unit;       ///< SI unit, "1" for none
};

/// All that a checkpoint or a record may hold.
std::vector<DatasetInfo> datasets_of(FileKind kind);

}  // namespace rupture
