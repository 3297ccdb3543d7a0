// The kinds of failure a user can meet; the tools map them to exit codes 2, 1 and 3.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace rupture {

/// An error whose sentence may be given as to fmt::format().
struct Error : std::runtime_error {
  explicit Error(const std::string& sentence) : std::runtime_error(sentence) {}
  template <class... Args>
  explicit Error(fmt::format_string<Args...> format, Args&&... args)
      : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A request that cannot be met: unknown name, value out of range, missing option.
struct UsageError : Error {
  using Error::Error;
};

/// A valid request that failed: damaged file, blow-up.
struct Failure : Error {
  using Error::Error;
};

/// The machine failed, not the request: full disk, no memory, no permission.
struct MachineFailure : Failure {
  using Failure::Failure;
};

}  // namespace rupture
