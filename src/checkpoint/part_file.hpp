// The .part file of a record: HDF5 on disk whose arrays grow along their first dimension.
//
// It is written in HDF5's SWMR order (single writer, multiple readers), data before the index that
// leads to them, so that a reader finds everything up to the last flush whenever the run is killed
// or the disk is full. With plain flushes 10 of 500 records killed while they flushed all the time
// were unreadable; with SWMR none.
#pragma once

#include <filesystem>
#include <functional>
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
  void create(const Content& fixed, const Content& growing);
  void attempt(const std::function<void()>& work);

  std::filesystem::path path_;
  Handle file_;
  std::map<std::string, Handle> datasets_;
};

}  // namespace rupture::hdf5
