// Datasets, attributes and file creation in terms of Content.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hdf5_handle.hpp"
#include "rupture/checkpoint/content.hpp"

namespace rupture::hdf5 {

/// Whether only files are read that are stored as rupture does, or also what other programs make of
/// them: chunks, compression, texts of any form, no units.
enum class Accept { own, edited };

/// The root attributes.
struct RootAttributes {
  std::string format;
  std::int64_t schema_version = 0;
  std::string content_checksum;
  std::string note = {};  ///< for people who open the file with another program; never read
};

/// What other programs are told about a dataset besides its unit.
struct Label {
  std::string long_name;
  std::vector<std::string>
      axes;  ///< dataset with the values along each dimension; itself in a scale, none if unknown
};
using Labels = std::map<std::string, Label>;  ///< by path

/// Properties of a new file: no times, room for our header in front.
Handle file_creation_properties();

/// The stored type of an element; `text_length` [bytes] only matters for text.
Handle stored_type(DataType type, std::size_t text_length);

void write_root_attributes(Id file, const RootAttributes& attributes);
void write_content(Id file, const Content& content);

/// Adds `labels` to datasets of `content`, which were written before. Nothing of ours reads them.
void write_labels(Id file, const Content& content, const Labels& labels);

/// Throws Failure if an attribute is missing or of the wrong kind.
RootAttributes read_root_attributes(Id file, Accept accept);

/// The version of rupture that wrote the file, which is at the same place in every schema. Throws
/// Failure if it is not there.
std::string read_writer_version(Id file);

/// All datasets. Throws Failure if they claim more than `file_size` bytes together, or if there is
/// anything but groups and datasets of known types that are stored in the file as we do. Edited
/// ones may claim a hundred times as much, as they may be compressed; units that are missing are
/// empty.
Content read_datasets(Id file, std::size_t file_size, Accept accept);

}  // namespace rupture::hdf5
