// What kinds of files there are.
#pragma once

#include <array>
#include <string_view>

#include "rupture/model/error.hpp"

namespace rupture {

/// `open_record` is a record that is still being written or whose run was interrupted: pieces that
/// follow each other, each with a header of its own.
enum class FileKind { checkpoint, record, open_record };
inline constexpr std::array kFileKinds = {FileKind::checkpoint, FileKind::record,
                                          FileKind::open_record};

/// First line of the header and root attribute `format`.
inline std::string_view format_name(FileKind kind) {
  constexpr std::array names = {"rupture-checkpoint", "rupture-record", "rupture-record-part"};
  return names.at(static_cast<std::size_t>(kind));
}

inline std::string_view kind_text(FileKind kind) {
  constexpr std::array texts = {"a checkpoint", "a record", "an unfinished record"};
  return texts.at(static_cast<std::size_t>(kind));
}

/// "checkpoint", "record", "unfinished record".
inline std::string_view kind_name(FileKind kind) {
  return kind_text(kind).substr(kind_text(kind).find(' ') + 1);
}

/// Thrown if a file is no checkpoint or record, or of a schema that this version does not read.
struct NotOurs : Failure {
  using Failure::Failure;
};

}  // namespace rupture
