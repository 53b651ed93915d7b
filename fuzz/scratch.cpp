#include "scratch.h"

#include <fstream>
#include <string>
#include <system_error>

#include <unistd.h>

namespace brindle::fuzz {
namespace {

/// Gone with the process.
class Scratch {
 public:
  Scratch()
      : folder_(
            std::filesystem::path(std::filesystem::is_directory("/dev/shm") ? "/dev/shm" : "/tmp") /
            ("brindle-fuzz-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path file(std::string_view name, std::span<const std::uint8_t> bytes) const {
    std::filesystem::path path = folder_ / name;
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return path;
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

}  // namespace

std::filesystem::path scratch_file(std::string_view name, std::span<const std::uint8_t> bytes) {
  return scratch().file(name, bytes);
}

std::filesystem::path scratch_path(std::string_view name) { return scratch().folder() / name; }

}  // namespace brindle::fuzz
