// The .part file of a record: HDF5 on disk whose arrays grow along their first dimension.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "hdf5_handle.hpp"
#include "rupture/checkpoint/content.hpp"

namespace rupture::hdf5 {

class PartFile {
 public:
  /// Creates the file, replacing one that is there, with `fixed` datasets that stay as they are and
  /// `growing` ones, of which type, unit and row shape (all but the first length) are taken.
  PartFile(std::filesystem::path path, const Content& fixed, const Content& growing);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  PartFile(PartFile&&) = delete;
  PartFile& operator=(PartFile&&) = delete;
  ~PartFile();

  /// Adds the rows of `rows` to the growing datasets of the same paths and brings everything to
  /// the operating system. Throws Failure naming the file.
  void append(const Content& rows);

  /// Closes the file; nothing may be appended afterwards.
  void close();

 private:
  void append_and_flush(const Content& rows);
  void abandon();

  std::filesystem::path path_;
  Handle file_;
  std::map<std::string, Handle> datasets_;
};

}  // namespace rupture::hdf5
