// The two kinds of failure a user can meet; the tools map them to exit codes 2 and 1.
#pragma once

#include <stdexcept>

namespace rupture {

/// A request that cannot be met: unknown name, value out of range, missing option.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A valid request that failed: damaged file, full disk, blow-up.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rupture
