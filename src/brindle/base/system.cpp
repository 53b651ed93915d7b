#include "brindle/base/system.h"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <optional>
#include <string>

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>
#else
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#if defined(__EMSCRIPTEN__)
#include <emscripten/heap.h>
#include <malloc.h>
#else
#include <fstream>
#endif

namespace brindle::system {
namespace {

namespace fs = std::filesystem;

constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

#if defined(_WIN32)

Descriptor open_device(const fs::path& path) { return _wopen(path.c_str(), _O_WRONLY | _O_BINARY); }

bool is_not_ready(int) { return false; }

void wait_a_moment() { Sleep(20); }

Descriptor open_unnamed(const fs::path&) {
  errno = ENOSYS;
  return -1;
}

Descriptor open_new(const fs::path& name) {
  return _wopen(name.c_str(), _O_CREAT | _O_EXCL | _O_RDWR | _O_BINARY, _S_IREAD | _S_IWRITE);
}

Descriptor open_existing(const fs::path& path) {
  return _wopen(path.c_str(), _O_RDONLY | _O_BINARY);
}

/// The most that the system reads or writes at once.
constexpr std::size_t kMost = std::size_t{1} << 30;

std::ptrdiff_t read_some(Descriptor file, char* bytes, std::size_t count) {
  return _read(file, bytes, static_cast<unsigned>(std::min(count, kMost)));
}

bool go_to(Descriptor file, std::uint64_t place) {
  return _lseeki64(file, static_cast<std::int64_t>(place), SEEK_SET) >= 0;
}

std::ptrdiff_t write_some(Descriptor file, const char* text, std::size_t count) {
  return _write(file, text, static_cast<unsigned>(std::min(count, kMost)));
}

bool close_file(Descriptor file) { return _close(file) == 0; }

fs::path place_of(Descriptor) { return {}; }

bool link_to(const fs::path&, const fs::path&) {
  errno = ENOSYS;
  return false;
}

void take_over(Descriptor, const fs::path&) {}

bool is_name_too_long(const fs::path& path) {
  return GetFileAttributesW(path.c_str()) == INVALID_FILE_ATTRIBUTES &&
         GetLastError() == ERROR_FILENAME_EXCED_RANGE;
}

bool may_write(const fs::path& path) { return _waccess(path.c_str(), 2) == 0; }

double free_memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) ? static_cast<double>(status.ullAvailPhys) : kUnknown;
}

double mappable_memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) ? static_cast<double>(status.ullAvailVirtual) : kUnknown;
}

bool can_map(std::size_t bytes) {
  void* const place = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  return place != nullptr && VirtualFree(place, 0, MEM_RELEASE) != 0;
}

double memory_of_group() { return kUnknown; }

void* function_named(const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(GetModuleHandleW(nullptr), name));
}

bool load_library(const char* name) { return LoadLibraryA(name) != nullptr; }

#else

Descriptor open_device(const fs::path& path) {
  return open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
}

bool is_not_ready(int reason) {
  return reason == ENXIO || reason == EAGAIN || reason == EWOULDBLOCK;
}

void wait_a_moment() { usleep(20'000); }

constexpr mode_t kMode = 0666;  // before the user's umask

Descriptor open_unnamed([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  const Descriptor file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
  std::error_code ignored;
  if (file < 0 || fs::exists(place_of(file), ignored)) return file;
  close(file);  // a file without a path here could not be named
#endif
  errno = ENOSYS;
  return -1;
}

Descriptor open_new(const fs::path& name) {
  return open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMode);
}

Descriptor open_existing(const fs::path& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }

std::ptrdiff_t read_some(Descriptor file, char* bytes, std::size_t count) {
  return read(file, bytes, count);
}

bool go_to(Descriptor file, std::uint64_t place) {
  return lseek(file, static_cast<off_t>(place), SEEK_SET) >= 0;
}

std::ptrdiff_t write_some(Descriptor file, const char* text, std::size_t count) {
  return write(file, text, count);
}

bool close_file(Descriptor file) { return close(file) == 0; }

fs::path place_of(Descriptor file) {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file);
}

bool link_to(const fs::path& place, const fs::path& name) {
  return linkat(AT_FDCWD, place.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

void take_over(Descriptor file, const fs::path& other) {
  struct stat old {};
  if (stat(other.c_str(), &old) != 0) return;
  if (fchown(file, old.st_uid, old.st_gid) != 0) {
    static_cast<void>(fchown(file, static_cast<uid_t>(-1), old.st_gid) == 0);
  }
  static_cast<void>(fchmod(file, old.st_mode & 0777));
}

bool is_name_too_long(const fs::path& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) != 0 && errno == ENAMETOOLONG;
}

bool may_write(const fs::path& path) { return access(path.c_str(), W_OK) == 0; }

#if defined(__EMSCRIPTEN__)

/// Memory by which the module may still grow, and free memory in it.
double free_memory() {
  const auto growth = static_cast<double>(emscripten_get_heap_max() - emscripten_get_heap_size());
  return growth + static_cast<double>(mallinfo().fordblks);
}

double mappable_memory() { return kUnknown; }
double memory_of_group() { return kUnknown; }

#else

double free_memory() {
  std::ifstream in("/proc/meminfo");
  for (std::string word; in >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && in >> kilobytes) return 1024 * kilobytes;
  }
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : kUnknown;
}

double mappable_memory() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  std::ifstream in("/proc/self/statm");
  double pages = 0;
  in >> pages;
  const double taken = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - taken);
}

/// The number at the start of a control group's file.
static std::optional<double> number_in(const char* path) {
  std::ifstream in(path);
  double number = 0;
  if (in >> number) return number;
  return std::nullopt;  // also for "max"
}

/// From the control group that the process sees as its root.
double memory_of_group() {
  constexpr const char* kFiles[][2] = {
      {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"},
      {"/sys/fs/cgroup/memory/memory.limit_in_bytes",
       "/sys/fs/cgroup/memory/memory.usage_in_bytes"}};
  for (const auto& [limit_file, usage_file] : kFiles) {
    const auto limit = number_in(limit_file), usage = number_in(usage_file);
    if (limit && usage) return std::max(0.0, *limit - *usage);
  }
  return kUnknown;
}

#endif

bool can_map(std::size_t bytes) {
  void* const place =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return place != MAP_FAILED && munmap(place, bytes) == 0;
}

void* function_named(const char* name) { return dlsym(RTLD_DEFAULT, name); }

bool load_library(const char* name) { return dlopen(name, RTLD_LAZY | RTLD_GLOBAL) != nullptr; }

#endif

}  // namespace brindle::system
