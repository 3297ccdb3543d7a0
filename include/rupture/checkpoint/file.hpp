// Files on disk: whole, verified, and written in one piece or not at all.
//
// None of these functions may run in two threads at once (libhdf5 is not thread-safe).
#pragma once

#include <filesystem>

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// Whether an existing file may be replaced.
enum class IfExists { refuse, replace };

/// Whether to write `<path>.sum`, a line with the content checksum, beside a file.
enum class SumFile { omit, write };

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

/// Reads a file and verifies everything that can be verified without knowing what the datasets
/// mean: its bytes, schema version, content checksum and finite numbers. libhdf5 opens it only if
/// its bytes are as they were sealed. Throws Failure, BrokenSeal if they are not.
ContentFile read_file(const std::filesystem::path& path);

/// Reads and verifies a file in memory, as read_file(); `name` is what messages call it.
ContentFile read_bytes(std::span<const std::byte> bytes, const std::string& name);

/// Reads it whatever its header says, so that a damaged file may crash libhdf5, and with it this
/// process. Throws Failure in one sentence that names the file, also if it holds no checkpoint or
/// record.
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
