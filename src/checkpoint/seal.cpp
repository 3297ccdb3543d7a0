// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "seal.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "hdf5_image.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/model/error.hpp"
#include "rupture/version.hpp"

namespace rupture {
namespace {

constexpr const char* kUnknown = "a newer rupture";  // that wrote a file

[[noreturn]] void refuse_newer(std::int64_t schema_version, const std::string& writer) {
  throw Failure(fmt::format(
      "written by {} (schema {}); this is rupture {}, which reads up to schema {}: use {}", writer,
      schema_version, version, kSchemaVersion, writer + (writer == kUnknown ? "" : " or newer")));
}

// Other programs see the first piece of a .part alone, which has no rows.
constexpr const char* kNoteInPieces =
    "the samples so far are in further pieces behind this one: rupture finish THIS -o NEW.h5 "
    "makes an ordinary record of them";

// "rupture 0.9.0", of a file of a newer schema.
std::string writer_of(const hdf5::Reader& reader) {
  try {
    return "rupture " + reader.writer_version();
  } catch (const Failure&) {
    return kUnknown;
  }
}

void check_attributes(const hdf5::RootAttributes& attributes, FileKind kind) {
  if (attributes.schema_version < 1 || attributes.format != format_name(kind)) {
    throw Failure(
        fmt::format("its header says {}, but its attributes say {}, schema version {}; "
                    "write it anew",
                    format_name(kind), attributes.format, attributes.schema_version));
  }
}

constexpr std::int64_t kLastWithAllParameters = 2;  // schema in whose checksum all of them count

// By the rule of the file's own schema.
std::string checksum_by_schema(std::int64_t schema_version, const Content& content) {
  return schema_version <= kLastWithAllParameters ? content_checksum_of_schema_2(content)
                                                  : content_checksum(content);
}

// A parameter that only a newer build knows is no damage, though it spoils the checksum.
void check_content(const Content& content, const hdf5::RootAttributes& attributes) {
  check_finite(content);
  refuse_unknown_parameters(content);
  const std::string& stored = attributes.content_checksum;
  const std::string computed = checksum_by_schema(attributes.schema_version, content);
  if (stored != computed) {
    throw Failure(
        fmt::format("its content has the checksum {}, but {} is stored in it; write it anew",
                    computed, stored));
  }
}

}  // namespace

Sealed seal(FileKind kind, const Content& content) {
  check_finite(content);
  const std::string checksum = content_checksum(content);
  std::vector<std::byte> bytes =
      hdf5::make_image({std::string(format_name(kind)), kSchemaVersion, checksum,
                        kind == FileKind::open_record ? kNoteInPieces : ""},
                       content);
  const std::string header = header_text(kind, std::span(bytes).subspan(kHeaderSize));
  std::memcpy(bytes.data(), header.data(), header.size());
  return {checksum, std::move(bytes)};
}

ContentFile unseal(FileKind kind, std::span<const std::byte> file) {
  const hdf5::Reader reader(file);
  const hdf5::RootAttributes attributes = reader.attributes();
  if (attributes.schema_version > kSchemaVersion) {
    refuse_newer(attributes.schema_version, writer_of(reader));
  }
  check_attributes(attributes, kind);
  Content content = reader.content();
  check_content(content, attributes);
  const bool by_present_rule = attributes.schema_version > kLastWithAllParameters;
  std::string checksum = by_present_rule ? attributes.content_checksum : content_checksum(content);
  return {kind, std::move(checksum), attributes.content_checksum, std::move(content)};
}

}  // namespace rupture
