// Files on disk: whole, verified, and written in one piece or not at all.
//
// None of these functions may run in two threads at once (libhdf5 is not thread-safe).
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "rupture/checkpoint/content.hpp"
#include "rupture/model/error.hpp"

namespace rupture {

inline constexpr std::int64_t kSchemaVersion = 3;  ///< of new files, the newest that is read
inline constexpr std::int64_t kOldestSchema = 2;   ///< that is read, by the rules of the newest

/// `open_record` is a record that is still being written or whose run was interrupted: pieces that
/// follow each other, each with a header of its own.
enum class FileKind { checkpoint, record, open_record };

/// The header in front of every file [bytes] (HDF5's user block): readable text with the kind of
/// file, its size, and the SHA-256 of all bytes that follow. It lets damage be seen before libhdf5
/// looks at anything, and has exactly one valid form for a given body, so that no bit of the file,
/// its own included, can change unnoticed.
inline constexpr std::size_t kHeaderSize = 512;

/// "rupture-checkpoint", "rupture-record" or "rupture-record-part": first line of the header and
/// root attribute `format`.
std::string_view format_name(FileKind kind);

/// "a checkpoint", "a record" or "an unfinished record".
std::string_view kind_text(FileKind kind);

/// "checkpoint", "record", "unfinished record".
inline std::string_view kind_name(FileKind kind) {
  return kind_text(kind).substr(kind_text(kind).find(' ') + 1);
}

/// The header, kHeaderSize bytes, that belongs in front of `body`.
std::string header_text(FileKind kind, std::span<const std::byte> body);

/// The kind that the first line of the header states, without any verification. `file` may hold the
/// whole file or its start. Throws Failure if it is empty, too short or not ours; `name` is the
/// file name for the message.
FileKind header_kind(std::span<const std::byte> file, const std::string& name);

/// Whether an existing file may be replaced.
enum class IfExists { refuse, replace };

/// Whether to write `<path>.sum`, a line with the content checksum, beside a file.
enum class SumFile { omit, write };

/// A file's kind and datasets.
struct ContentFile {
  FileKind kind = FileKind::checkpoint;
  std::string checksum;  ///< of the content; empty for an open record
  Content content;
  std::uint64_t ignored_bytes = 0;  ///< behind the last intact piece of an open record
};

/// Whether anything has this name, be it a link that leads nowhere. Throws Failure if that cannot
/// be found out.
bool is_there(const std::filesystem::path& path);

/// Throws Failure: the file exists and may not be replaced; `rather` names a better way.
[[noreturn]] void fail_existing(const std::filesystem::path& path, std::string_view rather = {});
inline constexpr std::string_view kResume = "--resume to continue its run, or ";

/// Throws Failure if a file could not be written to `path`: it exists and may not be replaced, it
/// is no regular file, or its folder is missing or read-only. Call it before a long run.
void check_output(const std::filesystem::path& path, IfExists if_exists);

/// Throws Failure if no file can be made, renamed and removed beside `path`. Call it as well.
void try_output(const std::filesystem::path& path);

/// The kind of file, from its header alone: cheap, and no verification. Throws Failure if there is
/// no such file or it is not ours.
FileKind identify(const std::filesystem::path& path);

/// Writes `content` and, on request, `<path>.sum` beside it; returns its checksum. Each of the two
/// appears complete or not at all. A .sum that already says the same is left alone; one that says
/// anything else is replaced or, without a request, removed. Throws Failure if a number is not
/// finite, the path may not be written or the disk is full. The path then holds what it held
/// before, unless it was only the .sum that could not be renamed; what is whole on the disk is kept
/// under a name that the message gives. A process that is killed can leave a file without its .sum,
/// but never with that of another.
std::string write_content(const std::filesystem::path& path, FileKind kind, const Content& content,
                          IfExists if_exists, SumFile sum = SumFile::omit);

/// Thrown if a file is not as it was sealed, but its HDF5 part can be read: another program may
/// have edited or repacked it.
struct Changed : Failure {
  using Failure::Failure;
};

/// Thrown if a file cannot be read here and now, whatever it holds: no permission, no memory, no
/// process to be had, or a filter that this machine lacks.
struct Unreadable : Failure {
  using Failure::Failure;
};

/// Whether libhdf5 opens a file in this process at once, or first in a child process, which costs
/// some milliseconds and turns a crash of libhdf5 into a Failure.
enum class Opening { here, in_child_first };

/// Reads a file and verifies everything that can be verified without knowing what the datasets
/// mean: its bytes, schema version, content checksum and finite numbers. Throws Failure, and
/// Changed or Unreadable where that can be told.
ContentFile read_file(const std::filesystem::path& path, Opening opening = Opening::here);

/// The same for a file in memory; `name` is what messages call it. Throws Failure, never Changed.
ContentFile read_bytes(std::span<const std::byte> bytes, const std::string& name,
                       Opening opening = Opening::here);

/// What a file holds that another program may have changed since rupture sealed it. How it is
/// stored does not matter: it may be cut into chunks and compressed, its texts may have any form,
/// units may be missing.
struct EditedFile {
  std::string name;  ///< for messages
  FileKind kind = FileKind::checkpoint;
  std::string sealed_checksum;  ///< content checksum that rupture stored; empty if it is gone
  bool content_is_as_sealed = false;
  Content content;
};

/// Reads it, first in a child process, in case the file makes libhdf5 crash. Throws
/// Failure in one sentence that names the file, also if it holds no checkpoint or record.
EditedFile read_edited(const std::filesystem::path& path);

/// Whether a run is writing this .part, which must exist, now. False where the file system has no
/// locks. Throws Failure if the file cannot be opened.
bool is_being_written(const std::filesystem::path& part);

/// `<path>.sum`.
std::filesystem::path sum_path(const std::filesystem::path& path);

/// Whether the path of a file's .sum is free, or holds a .sum of any version. Throws Failure.
bool may_replace_sum(const std::filesystem::path& path);

/// Writes the .sum of a file if it is missing, or says anything else and may be replaced. Throws
/// Failure.
void restore_sum(const std::filesystem::path& path, IfExists if_exists);

}  // namespace rupture
