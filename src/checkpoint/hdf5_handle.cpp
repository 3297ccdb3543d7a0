#include "hdf5_handle.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <string>
#include <type_traits>

#include "rupture/model/error.hpp"

namespace rupture::hdf5 {
namespace {

static_assert(std::is_same_v<Id, hid_t> && std::is_same_v<int, herr_t>);

// Walking up starts at the innermost error; the first line is the reason.
herr_t keep_innermost(unsigned n, const H5E_error2_t* error, void* reason) {
  if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

// For failed system calls HDF5 buries the reason among offsets and pointers.
std::string readable(const std::string& reason) {
  constexpr std::string_view key = "error message = '";
  const std::size_t at = reason.find(key);
  if (at == std::string::npos) return reason;
  const std::size_t start = at + key.size();
  return reason.substr(start, reason.find('\'', start) - start);
}

}  // namespace

void check(std::int64_t result, std::string_view doing) {
  if (result >= 0) return;
  std::string reason = "unknown reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  throw LibraryFailure(fmt::format("could not {}: {}", doing, readable(reason)));
}

void prepare() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace rupture::hdf5
