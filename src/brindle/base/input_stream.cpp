#include "brindle/base/input_stream.h"

#include <cerrno>
#include <cstring>
#include <iterator>

#include "brindle/base/printable.h"
#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(shown(path.string()) + ": " + why);
}

}  // namespace

std::ifstream open_input(const fs::path& path, const std::string& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    refuse(path, "there is no such file; check the path's spelling");
  }
  if (error) refuse(path, "cannot be read: " + error.message());
  if (fs::is_directory(status)) refuse(path, "is a folder; name " + kind + " in it");
  if (!fs::is_regular_file(status)) {
    refuse(path,
           "is not a regular file but a device or a pipe; save " + kind + " first and name that");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream) return stream;
  const std::string reason = errno == 0 || errno == EACCES ? "" : std::strerror(errno);
  refuse(path,
         "cannot be opened" + (reason.empty() ? "" : ": " + reason) + "; check its permissions");
}

std::string whole_input(const fs::path& path, const std::string& kind) {
  std::ifstream stream = open_input(path, kind);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) refuse(path, "cannot be read: input error");
  return content;
}

}  // namespace brindle
