// Files on disk: whole, verified, and written in one piece or not at all.
//
// None of these functions may run in two threads at once (libhdf5 is not thread-safe).
#pragma once

#include "rupture/checkpoint/content.hpp"
#include "rupture/checkpoint/header.hpp"
#include "rupture/checkpoint/output.hpp"

namespace rupture {

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
/// its bytes are as they were sealed. Throws Failure, BrokenSeal if they are not; also if a
/// checkpoint is `wanted` and it is none, or a record, be it unfinished, and it is none.
ContentFile read_file(const std::filesystem::path& path, std::optional<FileKind> wanted = {});

/// Reads and verifies a file in memory, as read_file(); `name` is what messages call it.
ContentFile read_bytes(std::span<const std::byte> bytes, const std::string& name);

/// Reads it whatever its header says, so that a damaged file may crash libhdf5, and with it this
/// process. Throws Failure in one sentence that names the file, also if it holds no checkpoint or
/// record.
EditedFile read_edited(const std::filesystem::path& path);

}  // namespace rupture
