// Checks of whole files, as read_checkpoint() and read_record() make them.
#pragma once

#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture {

/// Reads and verifies a checkpoint or record. Throws Failure if it is damaged, or an unfinished
/// record, which cannot be verified.
ContentFile verify_file(const std::filesystem::path& path);

/// The content to be sealed: checked as read_checkpoint() and read_record() do, with `entry` at the
/// end of its provenance and without the memory of the run. Throws Failure.
Content checked_content(const EditedFile& file, const ProvenanceEntry& entry);

}  // namespace rupture
