// Content to and from a complete HDF5 file in memory; libhdf5 never touches the disk. Nothing here
// includes hdf5.h.
#pragma once

#include "rupture/checkpoint/content.hpp"
#include "rupture/checkpoint/header.hpp"

namespace rupture::hdf5 {

using Id = std::int64_t;  // hid_t

inline constexpr const char* kNoFile = "/dev/null/rupture-image";  ///< HDF5 opens what it is told
inline constexpr std::size_t kGrowth = 1U << 20U;  ///< [bytes] step in which an image grows

/// Thrown where libhdf5 itself fails.
struct LibraryFailure : Failure {
  using Failure::Failure;
};

/// Throws LibraryFailure "cannot <doing>: <HDF5's innermost reason>" if an HDF5 call returned < 0.
void check(std::int64_t result, std::string_view doing);

/// Owns one HDF5 identifier, of whatever it is.
class Handle {
 public:
  Handle() = default;
  /// Throws Failure as check() does if `id` is the error value.
  Handle(Id id, std::string_view doing) : id_(id) { check(id, doing); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, kNone)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle();

  operator Id() const { return id_; }

 private:
  static constexpr Id kNone = 0;  // library-wide constants such as H5P_DEFAULT are never owned
  Id id_ = kNone;
};

/// To be called before anything else of HDF5. Stops it from printing its error stack (the reasons
/// go into our messages instead) and from cleaning up at exit, where it crashes if a file could not
/// be closed, as on a full disk; we close everything ourselves.
void prepare();

/// The stored type of an element; `text_length` [bytes] only matters for text.
Handle stored_type(DataType type, std::size_t text_length);

struct RootAttributes {
  std::string format;
  std::int64_t schema_version = 0;
  std::string content_checksum;
  std::string note = {};  ///< for people who open the file with another program; never read
};

/// A whole file: kHeaderSize zero bytes, to be overwritten by the header, then the HDF5 part.
/// Equal arguments give equal bytes.
std::vector<std::byte> make_image(const RootAttributes& attributes, const Content& content,
                                  const Labels& labels = {});

/// Whether only files are read that are stored as rupture does, or also what other programs make of
/// them: chunks, compression, texts of any form, no units.
enum class Accept { own, edited };

/// A file opened for reading. Throws Failure if libhdf5 cannot open it.
class Reader {
 public:
  /// A verified file in memory, which must outlive the reader.
  explicit Reader(std::span<const std::byte> file, Accept accept = Accept::own);

  /// Throws Failure if an attribute is missing or of the wrong kind.
  RootAttributes attributes() const;

  /// The version of rupture that wrote the file, which is at the same place in every schema. Throws
  /// Failure if it is not there.
  std::string writer_version() const;

  /// All datasets. Throws Failure if they claim more than the file holds together, or if there is
  /// anything but groups and datasets of known types that are stored in the file as we do. Edited
  /// ones may claim a hundred times as much, as they may be compressed; units that are missing are
  /// empty.
  Content content() const;

 private:
  std::size_t size_;
  Accept accept_;
  Handle file_;
};

}  // namespace rupture::hdf5
