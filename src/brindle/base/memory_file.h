/// Files in memory, for programs without a file system.
#pragma once

#include <filesystem>
#include <string>

namespace brindle {

/// A file in memory. As long as it lives, readers and writers of its thread use it under its name
/// instead of the system's file.
class MemoryFile {
 public:
  explicit MemoryFile(std::filesystem::path name, std::string content = "");
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// The last one of this name that lives; null if there is none.
  static MemoryFile* find(const std::filesystem::path& name);

  const std::filesystem::path& name() const { return name_; }
  std::string content;

 private:
  std::filesystem::path name_;
  MemoryFile* outer_;  ///< the one made before
};

}  // namespace brindle
