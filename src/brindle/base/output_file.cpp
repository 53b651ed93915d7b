#include "brindle/base/output_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include <unistd.h>

#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

[[noreturn]] void fail(const fs::path& path, int reason) {
  std::string message = "cannot write '" + path.string() + "'";
  if (reason != 0) message += std::string(": ") + std::strerror(reason);
  const fs::path folder = folder_of(path);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    message += "; the folder '" + folder.string() + "' does not exist, create it first";
  } else if (reason == ENOSPC) {
    message += "; free some space or choose another folder";
  } else {
    message += "; check the folder's permissions or choose another path";
  }
  throw Error(message);
}

void refuse_folder(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return;
  throw Error("cannot write '" + path.string() + "': it is a folder; name a file in it");
}

void write_to(const fs::path& path, const fs::path& named,
              const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out) fail(named, errno);
  write(out);
  out.flush();
  if (!out) fail(named, errno);
  out.close();
  if (!out) fail(named, errno);
}

fs::path temporary_name(const fs::path& path) {
  std::random_device seed;
  fs::path name = path;
  name += ".tmp" + std::to_string(seed());
  return name;
}

}  // namespace

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  refuse_folder(path);
  if (is_device(path)) {
    write_to(path, path, write);
    return;
  }
  std::error_code ignored;
  const fs::path temporary = temporary_name(path);
  try {
    write_to(temporary, path, write);
    fs::rename(temporary, path);
  } catch (const fs::filesystem_error& error) {
    fs::remove(temporary, ignored);
    fail(path, error.code().value());
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

void check_output_path(const fs::path& path) {
  refuse_folder(path);
  const fs::path written = is_device(path) ? path : folder_of(path) / ".";
  if (access(written.c_str(), W_OK) != 0) fail(path, errno);
}

}  // namespace brindle
