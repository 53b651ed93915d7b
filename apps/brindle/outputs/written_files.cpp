#include "outputs/written_files.h"

#include <cstdint>
#include <ostream>
#include <string>

#include "brindle/base/output_file.h"
#include "brindle/base/text.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

// 0 for a device.
std::uintmax_t size_of(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  return error ? 0 : size;
}

std::string readable(std::uintmax_t size) {
  const auto bytes = static_cast<double>(size);
  if (bytes < 1e3) return formatted("%.0f bytes", bytes);
  if (bytes < 1e6) return formatted("%.1f kB", 1e-3 * bytes);
  if (bytes < 1e9) return formatted("%.1f MB", 1e-6 * bytes);
  return formatted("%.1f GB", 1e-9 * bytes);
}

}  // namespace

void print_written(std::ostream& out, const fs::path& file) {
  print_written(out, std::span(&file, 1));
}

void print_written(std::ostream& out, std::span<const fs::path> files) {
  if (files.empty()) return;
  std::uintmax_t size = 0;
  for (const fs::path& file : files) size += size_of(file);
  out << "wrote " << shown(files.front().native());
  if (files.size() == 1 && is_device(files.front())) {
    out << '\n';
    return;
  }
  if (files.size() > 1) out << " to " << shown(files.back().native());
  out << " (" << (files.size() > 1 ? formatted("%zu files, ", files.size()) : "") << readable(size)
      << ")\n";
}

}  // namespace brindle::tool
