/// Interface to the operating system: all that the core uses of POSIX and Windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace brindle::system {

/// The number of an open file; below 0 on failure. Failing functions leave the reason in errno.
using Descriptor = int;

/// Opens an existing device or pipe for writing, without waiting: see `is_not_ready`.
Descriptor open_device(const std::filesystem::path& path);
/// Whether this reason means that a pipe has no reader yet, or a slow one.
bool is_not_ready(int reason);
/// Sleeps for about 20 milliseconds.
void wait_a_moment();
/// Opens an unnamed file in `folder`. Fails if the system or the file system does not support that.
Descriptor open_unnamed(const std::filesystem::path& folder);
/// Creates a file; fails if the name is taken.
Descriptor open_new(const std::filesystem::path& name);
/// Opens an existing file for reading, as bytes.
Descriptor open_existing(const std::filesystem::path& path);
/// Returns how many of the next `count` bytes were read: 0 at the end, -1 for a failure.
std::ptrdiff_t read_some(Descriptor file, char* bytes, std::size_t count);
/// Sets the position of the next byte; false on failure.
bool go_to(Descriptor file, std::uint64_t place);
/// Returns the number of bytes written: at least 1, or -1 on failure.
std::ptrdiff_t write_some(Descriptor file, const char* text, std::size_t count);
/// Closes the file; false if written data could not be stored.
bool close_file(Descriptor file);
/// A path by which other programs can open an unnamed file while it is open.
std::filesystem::path place_of(Descriptor file);
/// Names the file at `place`, which may be unnamed; false on failure.
bool link_to(const std::filesystem::path& place, const std::filesystem::path& name);
/// Gives an open file the owner and permissions of another, as far as the user and the file system
/// allow.
void take_over(Descriptor file, const std::filesystem::path& other);
/// Whether `path` exceeds the system's limit.
bool is_name_too_long(const std::filesystem::path& path);
/// Whether this user may write to `path`.
bool may_write(const std::filesystem::path& path);

/// Bytes available without swapping; infinity if unknown.
double free_memory();
/// Bytes that the process may still map; infinity if there is no limit.
double mappable_memory();
/// Bytes left to the container that the process runs in; infinity if there is no limit.
double memory_of_group();
/// Whether this many bytes could be mapped now.
bool can_map(std::size_t bytes);

/// A function of the process or of a loaded library; null if none has that name.
void* function_named(const char* name);
/// Loads a library and makes its functions visible to the process; false if it is missing.
bool load_library(const char* name);

}  // namespace brindle::system
