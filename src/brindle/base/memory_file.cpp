#include "brindle/base/memory_file.h"

#include <utility>

namespace brindle {
namespace {

thread_local MemoryFile* newest_file = nullptr;

}  // namespace

MemoryFile::MemoryFile(std::filesystem::path name, std::string bytes)
    : content(std::move(bytes)), name_(std::move(name)), outer_(std::exchange(newest_file, this)) {}

MemoryFile::~MemoryFile() { newest_file = outer_; }

MemoryFile* MemoryFile::find(const std::filesystem::path& name) {
  MemoryFile* file = newest_file;
  while (file != nullptr && file->name_ != name) file = file->outer_;
  return file;
}

}  // namespace brindle
