#include "part_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "atomic_write.hpp"
#include "context.hpp"
#include "hdf5_objects.hpp"
#include "rupture/checkpoint/file.hpp"

namespace rupture::hdf5 {
namespace {

constexpr hsize_t kChunkBytes = 1U << 16U;  // about what one flush of a usual record adds

Handle create_file(const std::filesystem::path& path) {
  const Handle creation = file_creation_properties();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare a file");
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the format");
  // Locks would keep other programs from looking at the record of a run in progress.
  check(H5Pset_file_locking(access, false, true), "do without file locks");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose, "create the file"};
}

Handle create_growing(Id file, const std::string& path, const Dataset& row) {
  const std::string doing = fmt::format("create {}", path);
  create_groups(file, path);
  std::vector<hsize_t> lengths(row.shape.begin(), row.shape.end());
  std::vector<hsize_t> limits = lengths;
  lengths[0] = 0;
  limits[0] = H5S_UNLIMITED;
  const Handle type = stored_type(row.type, 0);
  const Handle space(
      H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), limits.data()), H5Sclose,
      doing);
  hsize_t row_bytes = H5Tget_size(type);
  for (std::size_t d = 1; d < lengths.size(); ++d) row_bytes *= lengths[d];
  std::vector<hsize_t> chunk = limits;
  chunk[0] = std::max<hsize_t>(1, kChunkBytes / row_bytes);
  const Handle properties = dataset_creation_properties();
  check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), doing);
  Handle dataset(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                 H5Dclose, doing);
  write_unit(dataset, row.unit);
  return dataset;
}

hsize_t rows_in(Id dataset, const std::string& doing) {
  const Handle space(H5Dget_space(dataset), H5Sclose, doing);
  std::vector<hsize_t> lengths(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  check(H5Sget_simple_extent_dims(space, lengths.data(), nullptr), doing);
  return lengths[0];
}

void append_rows(Id dataset, const std::string& path, const Dataset& rows) {
  const std::string doing = fmt::format("append to {}", path);
  const std::vector<hsize_t> count(rows.shape.begin(), rows.shape.end());
  std::vector<hsize_t> start(count.size(), 0);
  start[0] = rows_in(dataset, doing);
  std::vector<hsize_t> lengths = count;
  lengths[0] += start[0];
  check(H5Dset_extent(dataset, lengths.data()), doing);
  const Handle type(H5Dget_type(dataset), H5Tclose, doing);
  const Handle target(H5Dget_space(dataset), H5Sclose, doing);
  check(H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        doing);
  const Handle source(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                      H5Sclose, doing);
  check(H5Dwrite(dataset, type, source, target, H5P_DEFAULT, rows.bytes.data()), doing);
}

}  // namespace

PartFile::PartFile(std::filesystem::path path, const Content& fixed, const Content& growing)
    : path_(std::move(path)) {
  prepare();
  try {
    attempt([&] { create(fixed, growing); });
    overwrite_start(path_, header_text(FileKind::open_record, {}));
  } catch (const Failure&) {
    std::error_code ignored;  // what could not be created may not be there either
    std::filesystem::remove(path_, ignored);
    throw;
  }
}

PartFile::~PartFile() {
  const FileSizeSignalBlocked guard;
  datasets_.clear();
  file_ = Handle();
}

void PartFile::append(const Content& rows) {
  attempt([&] {
    for (const auto& [name, added] : rows) {
      if (added.shape[0] > 0) append_rows(datasets_.at(name), name, added);
    }
    check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "write to the disk");
  });
}

void PartFile::close() {
  attempt([&] {
    for (auto& [name, dataset] : datasets_) dataset.close("close " + name);
    file_.close("close the file");
  });
}

void PartFile::create(const Content& fixed, const Content& growing) {
  file_ = create_file(path_);
  write_root_attributes(file_,
                        {std::string(format_name(FileKind::open_record)), kSchemaVersion, ""});
  write_content(file_, fixed);
  for (const auto& [name, row] : growing) {
    datasets_.emplace(name, create_growing(file_, name, row));
  }
  check(H5Fstart_swmr_write(file_), "open the file for readers");
}

// After a failure the file is left as it is: closing it would still try to write an index of data
// that did not get to the disk.
void PartFile::attempt(const std::function<void()>& work) {
  const FileSizeSignalBlocked guard;
  try {
    naming(path_, work);
  } catch (const Failure&) {
    for (auto& [name, dataset] : datasets_) dataset.abandon();
    file_.abandon();
    throw;
  }
}

}  // namespace rupture::hdf5
