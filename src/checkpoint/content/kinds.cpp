#include "rupture/checkpoint/kinds.hpp"

#include <array>

namespace rupture {
namespace {

struct KindRow {
  std::string_view format, words;
};
constexpr std::array<KindRow, kFileKinds.size()> kRowOfKind = {
    {{"rupture-checkpoint", "a checkpoint"},
     {"rupture-record", "a record"},
     {"rupture-record-part", "an unfinished record"}}};

}  // namespace

std::string_view format_name(FileKind kind) {
  return kRowOfKind.at(static_cast<std::size_t>(kind)).format;
}

std::string_view kind_text(FileKind kind) {
  return kRowOfKind.at(static_cast<std::size_t>(kind)).words;
}

}  // namespace rupture
