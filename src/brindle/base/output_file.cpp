#include "brindle/base/output_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include "brindle/base/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int reason) {
  std::string message = "cannot write '" + path.string() + "'";
  if (reason != 0) message += std::string(": ") + std::strerror(reason);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
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
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw Error("cannot write '" + path.string() + "': it is a folder; name a file in it");
  }
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    write_to(path, path, write);
    return;
  }
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

}  // namespace brindle
