/// Temporary folders.
#pragma once

#include <filesystem>

namespace brindle::tool {

/// An empty folder with a unique name in the system's place for temporary files; removed with its
/// content on destruction.
class TemporaryFolder {
 public:
  /// Throws Error if it cannot be created.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace brindle::tool
