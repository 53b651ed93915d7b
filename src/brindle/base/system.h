/// What is asked of the operating system: all that the core knows of POSIX and of Windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace brindle::system {

/// The number of an open file; below 0 if there is none, and errno says why.
using Descriptor = int;

/// Of what is there: a device, a pipe. Nothing waits: see `is_not_ready`.
Descriptor open_device(const std::filesystem::path& path);
/// Whether errno says that a pipe has no reader yet, or one that is behind.
bool is_not_ready(int reason);
/// Some hundredths of a second.
void wait_a_moment();
/// A file in `folder` that has no name yet. None where the system or its file system knows no such.
Descriptor open_unnamed(const std::filesystem::path& folder);
/// A file under a name that nothing has yet.
Descriptor open_new(const std::filesystem::path& name);
/// A file that is there, for reading, as bytes.
Descriptor open_existing(const std::filesystem::path& path);
/// How many of the next `count` bytes were read: 0 at the end, or -1, and errno says why.
std::ptrdiff_t read_some(Descriptor file, char* bytes, std::size_t count);
/// Whether the next byte will be read there, or errno says why not.
bool go_to(Descriptor file, std::uint64_t place);
/// How much of the text was written: at least a byte of it, or -1, and errno says why.
std::ptrdiff_t write_some(Descriptor file, const char* text, std::size_t count);
/// Whether all that was written is there, or errno says why not.
bool close_file(Descriptor file);
/// By what other programs can open a file without a name, as long as it is open.
std::filesystem::path place_of(Descriptor file);
/// Whether the file at `place`, which may have no name, now has this one, or errno says why not.
bool link_to(const std::filesystem::path& place, const std::filesystem::path& name);
/// Gives an open file the owner and permissions of another, as far as this user and the file system
/// may.
void take_over(Descriptor file, const std::filesystem::path& other);
/// Whether `path` is longer than the system takes.
bool is_name_too_long(const std::filesystem::path& path);
/// Whether this user may write there, or errno says why not.
bool may_write(const std::filesystem::path& path);

/// Bytes that could be had without swapping; infinity if nobody knows.
double free_memory();
/// Bytes that the process may still map; infinity if there is no limit.
double mappable_memory();
/// Bytes that are left to the container that the process may be in; infinity if there is no limit.
double memory_of_group();
/// Whether so many bytes could be mapped now.
bool can_map(std::size_t bytes);

/// A function of the process or of a library that it has loaded; null if there is none of that
/// name.
void* function_named(const char* name);
/// Whether the library is there; what it has can then be found by all.
bool load_library(const char* name);

}  // namespace brindle::system
