#include "checkpoint/sealed/seal.hpp"

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/record_layout.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/parameters_content.hpp"
#include "rupture/version.hpp"

namespace rupture {
namespace {

constexpr std::int64_t kSchemaVersion = 3;  // of new files, the newest that is read
constexpr std::int64_t kOldestSchema = 2;   // that is read, by the rules of the newest

constexpr const char* kUnknown = "a newer rupture";  // that wrote a file

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

// Of a file that this version does not read, or not with its checksum.
[[noreturn]] void refuse_old(const hdf5::RootAttributes& attributes, const char* which) {
  const bool is_checkpoint = attributes.format == format_name(FileKind::checkpoint);
  throw NotOurs("it has schema {}{}; this version reads schemas {} and {}: {}",
                attributes.schema_version, which, kOldestSchema, kSchemaVersion,
                is_checkpoint
                    ? "convert it once with rupture 0.4.0: rupture restart OLD.h5 --for 0 -o NEW.h5"
                    : "make the record again with the command that rupture analyze show of "
                      "rupture 0.4.0 prints");
}

hdf5::RootAttributes attributes_of(const hdf5::Reader& reader) {
  hdf5::RootAttributes attributes = reader.attributes();
  if (attributes.schema_version < kOldestSchema) refuse_old(attributes, "");
  if (attributes.schema_version <= kSchemaVersion) return attributes;
  const std::string writer = writer_of(reader);
  throw NotOurs(
      "written by {} (schema {}); this is rupture {}, which reads up to schema {}: use {}{}",
      writer, attributes.schema_version, version, kSchemaVersion, writer,
      writer == kUnknown ? "" : " or newer");
}

// That of a file without header. An unfinished record is no whole file.
FileKind kind_called(const std::string& format) {
  for (const FileKind kind : {FileKind::checkpoint, FileKind::record}) {
    if (format == format_name(kind)) return kind;
  }
  fail("its attribute format is '{}'; expected {} or {}", format, format_name(FileKind::checkpoint),
       format_name(FileKind::record));
}

void append_rows(const std::string& path, Dataset& whole, const Dataset& rows) {
  const auto row_shape = [](const Dataset& dataset) {
    return Shape(dataset.shape.begin() + (dataset.shape.empty() ? 0 : 1), dataset.shape.end());
  };
  if (whole.shape.empty() || rows.shape.empty() || whole.type != rows.type ||
      row_shape(whole) != row_shape(rows)) {
    fail("rows of {} do not continue those of the previous pieces", path);
  }
  whole.shape[0] += rows.shape[0];
  whole.bytes.insert(whole.bytes.end(), rows.bytes.begin(), rows.bytes.end());
}

}  // namespace

Sealed seal(FileKind kind, const Content& content) {
  check_finite(content);
  const bool is_piece = kind == FileKind::open_record;  // which nothing compares
  const std::string checksum = is_piece ? std::string() : content_checksum(content);
  const auto labels = kind == FileKind::record ? record_labels(content) : Labels{};
  std::vector<std::byte> bytes = hdf5::make_image(
      {std::string(format_name(kind)), kSchemaVersion, checksum, is_piece ? kNoteInPieces : ""},
      content, labels);
  const std::string header = header_text(kind, std::span(bytes).subspan(kHeaderSize));
  std::memcpy(bytes.data(), header.data(), header.size());
  return {checksum, std::move(bytes)};
}

ContentFile unseal(FileKind kind, std::span<const std::byte> file) {
  const hdf5::Reader reader(file);
  const hdf5::RootAttributes attributes = attributes_of(reader);
  if (attributes.format != format_name(kind)) {
    fail("its header says {}, but its attributes say {}, schema version {}; recreate it",
         format_name(kind), attributes.format, attributes.schema_version);
  }
  ContentFile unsealed = {kind, attributes.content_checksum, reader.content()};
  check_finite(unsealed.content);
  // One that only a newer build knows is not damage, although it changes the checksum.
  refuse_unknown_parameters(unsealed.content);
  if (kind == FileKind::open_record) return unsealed;  // its pieces have checksums of their own
  const std::string computed = content_checksum(unsealed.content);
  if (computed == unsealed.checksum) return unsealed;
  if (attributes.schema_version < kSchemaVersion) {
    refuse_old(attributes, " and sets parameters that its interface law does not use");
  }
  fail("its content has the checksum {}, but {} is stored in it; recreate it", computed,
       unsealed.checksum);
}

ContentFile put_together(std::span<const std::byte> file) {
  const std::size_t first = intact_piece(file);
  if (first == 0) throw Failure("the first piece of the unfinished record is damaged");
  ContentFile whole = unseal(FileKind::open_record, file.first(first));
  file = file.subspan(first);
  while (const std::size_t size = intact_piece(file)) {
    const ContentFile piece = unseal(FileKind::open_record, file.first(size));
    for (const auto& [path, rows] : piece.content) {
      const auto found = whole.content.find(path);
      if (found == whole.content.end()) {
        fail("{} is missing in the first piece of the record", path);
      }
      append_rows(path, found->second, rows);
    }
    file = file.subspan(size);
  }
  whole.ignored_bytes = file.size();
  return whole;
}

EditedFile open_edited(std::span<const std::byte> file) {
  const hdf5::Reader reader(file, hdf5::Accept::edited);
  const hdf5::RootAttributes attributes = attributes_of(reader);
  EditedFile edited;
  edited.kind = kind_called(attributes.format);
  const std::string& checksum = attributes.content_checksum;  // or what an editor has left of it
  const bool is_whole = checksum.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (checksum.size() == 64 && is_whole) edited.sealed_checksum = checksum;
  edited.content = reader.content();
  check_finite(edited.content);
  edited.content_is_as_sealed = content_checksum(edited.content) == edited.sealed_checksum;
  return edited;
}

}  // namespace rupture
