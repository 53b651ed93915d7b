/// A folder for files that nobody keeps.
#pragma once

#include <filesystem>

namespace brindle::tool {

/// Empty, with a name of its own where the system keeps temporary files; removed with all that is
/// in it when this goes.
class TemporaryFolder {
 public:
  /// Throws Error if it cannot be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace brindle::tool
