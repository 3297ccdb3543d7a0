// Puts the name of the file in front of what went wrong inside it.
#pragma once

#include <fmt/format.h>

#include <filesystem>

#include "rupture/model/error.hpp"

namespace rupture {

template <class Work>
auto naming(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const Failure& failure) {
    throw Failure(fmt::format("{}: {}", path.string(), failure.what()));
  }
}

}  // namespace rupture
