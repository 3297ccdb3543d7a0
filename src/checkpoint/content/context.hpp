// Failures: what went wrong, and in which file.
#pragma once

#include <filesystem>

#include "rupture/checkpoint/kinds.hpp"

namespace rupture {

/// Throws Failure with a message in the words of fmt::format().
template <class... Args>
[[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... values) {
  throw Failure(format, std::forward<Args>(values)...);
}

/// Throws what `failure` is, with another message.
template <class... Args>
[[noreturn]] void fail_like(const Failure& failure, fmt::format_string<Args...> format,
                            Args&&... values) {
  const std::string message = fmt::format(format, std::forward<Args>(values)...);
  if (dynamic_cast<const MachineFailure*>(&failure) != nullptr) throw MachineFailure(message);
  throw Failure(message);
}

/// Puts the name of the file in front of what goes wrong in `work`.
auto naming(const std::filesystem::path& path, const auto& work) {
  try {
    return work();
  } catch (const NotOurs& failure) {
    throw NotOurs("{}: {}", path.string(), failure.what());
  } catch (const Failure& failure) {
    fail_like(failure, "{}: {}", path.string(), failure.what());
  }
}

}  // namespace rupture
