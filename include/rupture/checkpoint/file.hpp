// Files on disk: whole, verified, and written in one piece or not at all.
//
// None of these functions may run in two threads at once (libhdf5 is not thread-safe).
#pragma once

#include <filesystem>

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// Whether an existing file may be replaced.
enum class IfExists { refuse, replace };

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

/// Writes `content`; returns its checksum. The file appears complete or not at all. Throws Failure
/// if a number is not finite, the path may not be written or the disk is full. The path then holds
/// what it held before; what is whole on the disk is kept under a name that the message gives.
std::string write_content(const std::filesystem::path& path, FileKind kind, const Content& content,
                          IfExists if_exists);

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

}  // namespace rupture
