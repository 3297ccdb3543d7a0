// Ownership and error checks for HDF5's C interface; nothing here includes hdf5.h.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

#include "rupture/model/error.hpp"

namespace rupture::hdf5 {

using Id = std::int64_t;  // hid_t
using Close = int (*)(Id);

/// Thrown where libhdf5 itself fails.
struct LibraryFailure : Failure {
  using Failure::Failure;
};

/// Throws LibraryFailure "could not <doing>: <HDF5's innermost reason>" if an HDF5 call returned
/// < 0.
void check(std::int64_t result, std::string_view doing);

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle() = default;
  /// Throws Failure as check() does if `id` is the error value.
  Handle(Id id, Close closer, std::string_view doing) : id_(id), close_(closer) {
    check(id, doing);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, kNone)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ > kNone) close_(id_);
  }

  operator Id() const { return id_; }

 private:
  static constexpr Id kNone = 0;  // library-wide constants such as H5P_DEFAULT are never owned
  Id id_ = kNone;
  Close close_ = nullptr;
};

/// To be called before anything else of HDF5. Stops it from printing its error stack (the reasons
/// go into our messages instead) and from cleaning up at exit, where it crashes if a file could not
/// be closed, as on a full disk; we close everything ourselves.
void prepare();

}  // namespace rupture::hdf5
