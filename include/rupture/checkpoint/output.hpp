// Where files may be written.
#pragma once

#include <filesystem>
#include <string_view>

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

/// Whether a run is writing this .part, which must exist, now. False where the file system has no
/// locks. Throws Failure if the file cannot be opened.
bool is_being_written(const std::filesystem::path& part);

}  // namespace rupture
