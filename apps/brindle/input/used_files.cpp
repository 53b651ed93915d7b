#include "input/used_files.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <sys/stat.h>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/files.h"
#include "input/csv_field.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

// One name for all paths to a file, which need not exist.
fs::path place_of(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

// Device and inode, equal for all links to a file; empty if it does not exist.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileId(status.st_dev, status.st_ino);
}

// Finds inputs by any path or link. A series has thousands.
class Inputs {
 public:
  explicit Inputs(const std::vector<UsedFile>& files) {
    for (const UsedFile& file : files) {
      by_place_.emplace(place_of(file.path), &file);
      if (const auto id = id_of(file.path)) by_id_.emplace(*id, &file);
    }
  }

  // The input that is this file, or null.
  const UsedFile* find(const fs::path& path) const {
    const auto at_place = by_place_.find(place_of(path));
    if (at_place != by_place_.end()) return at_place->second;
    const auto id = id_of(path);
    const auto same = id ? by_id_.find(*id) : by_id_.end();
    return same == by_id_.end() ? nullptr : same->second;
  }

 private:
  std::map<fs::path, const UsedFile*> by_place_;
  std::map<FileId, const UsedFile*> by_id_;
};

// The inputs and the files that they refer to, such as glTF buffers. Inputs are read for that only
// if an output would replace a file.
std::vector<UsedFile> with_named_files(const std::vector<UsedFile>& inputs,
                                       const std::vector<UsedFile>& outputs) {
  std::vector<UsedFile> files = inputs;
  std::error_code ignored;
  const bool replace = std::ranges::any_of(
      outputs, [&](const UsedFile& output) { return fs::is_regular_file(output.path, ignored); });
  if (!replace) return files;
  for (const UsedFile& input : inputs) {
    if (lower_extension(input.path) != ".gltf") continue;
    for (const fs::path& path : gltf_buffer_files(input.path)) {
      files.push_back({input.option, path});
    }
  }
  return files;
}

}  // namespace

std::vector<UsedFile> input_files(const SurfaceOptions& surface, const WaveOptions& waves) {
  if (surface.mesh.empty()) throw CLI::ValidationError("MESH", "name a mesh file or a shape");
  std::vector<UsedFile> files;
  if (!is_shape(surface)) files.push_back({"MESH", surface.mesh});
  for (UsedFile& file : field_files(waves)) files.push_back(std::move(file));
  return files;
}

std::vector<UsedFile> field_files(const WaveOptions& waves) {
  std::vector<UsedFile> files;
  if (is_field_file(waves)) files.push_back({"--field", csv_field_name(waves.field).path});
  if (!waves.strokes.empty()) files.push_back({"--strokes", waves.strokes});
  const std::string frequencies = value_file(waves.arrays.frequency_by);
  if (!frequencies.empty()) files.push_back({"--frequency-by", frequencies});
  const std::string weights = value_file(waves.smoothing.weight);
  if (!weights.empty()) files.push_back({"--field-weight", weights});
  if (!waves.arrays.mesh.empty()) files.push_back({"--field-mesh", waves.arrays.mesh});
  return files;
}

void check_files(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs) {
  const std::vector<UsedFile> used = with_named_files(inputs, outputs);
  const Inputs known(used);
  std::map<fs::path, const UsedFile*> written;
  for (const UsedFile& output : outputs) {
    if (is_device(output.path)) continue;
    const auto refuse = [&](const std::string& reason) {
      throw CLI::ValidationError(output.option, "'" + shown(output.path.native()) + "' " + reason);
    };
    if (const UsedFile* input = known.find(output.path)) {
      refuse("is read by " + input->option + " and would be lost; write to another file");
    }
    const auto [other, is_new] = written.emplace(place_of(output.path), &output);
    if (!is_new && !(output.beside && other->second->beside)) {
      refuse("would be written twice; write to another file");
    }
  }
}

void check_report(const std::string& option, const std::string& path) {
  if (path.empty()) return;
  if (lower_extension(path) != ".json" && !is_device(path)) {
    throw CLI::ValidationError(option,
                               "'" + shown(path) + "' is no name of a report; end it in .json");
  }
  check_output_path(path);
}

}  // namespace brindle::tool
