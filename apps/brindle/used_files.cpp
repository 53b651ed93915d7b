#include "used_files.h"

#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "brindle/base/file_extension.h"
#include "brindle/base/output_file.h"
#include "csv_field.h"
#include "vertex_values.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

// One name for all ways to a file, whether or not it exists.
fs::path place_of(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
}

// What all links to an existing file share; nothing for one that does not exist.
using FileId = std::pair<dev_t, ino_t>;

std::optional<FileId> id_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileId(status.st_dev, status.st_ino);
}

// Finds inputs by any way that leads to them. A series has thousands.
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

// What a glTF file names beside itself; nothing of a file that cannot be read, which is for the
// reader to say.
std::vector<fs::path> buffers_of(const fs::path& gltf) {
  std::vector<fs::path> paths;
  std::ifstream in(gltf);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array()) return paths;
  for (const auto& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const std::string uri = buffer["uri"];
    if (!uri.starts_with("data:")) paths.push_back(gltf.parent_path() / uri);
  }
  return paths;
}

std::vector<UsedFile> files_of_mesh(const std::string& option, const fs::path& mesh) {
  std::vector<UsedFile> files = {{option, mesh}};
  if (lower_extension(mesh) != ".gltf") return files;
  for (const fs::path& path : buffers_of(mesh)) files.push_back({option, path});
  return files;
}

}  // namespace

std::vector<UsedFile> input_files(const SurfaceOptions& surface, const WaveOptions& waves) {
  if (surface.mesh.empty()) throw CLI::ValidationError("MESH", "name a mesh file or a shape");
  std::vector<UsedFile> files;
  if (!is_shape(surface)) files = files_of_mesh("MESH", surface.mesh);
  for (UsedFile& file : field_files(waves)) files.push_back(std::move(file));
  return files;
}

std::vector<UsedFile> field_files(const WaveOptions& waves) {
  std::vector<UsedFile> files;
  if (is_field_file(waves)) files.push_back({"--field", csv_field_name(waves.field).path});
  if (!waves.strokes.empty()) files.push_back({"--strokes", waves.strokes});
  const std::string frequencies = value_file(waves.arrays.frequency_by);
  if (!frequencies.empty()) files.push_back({"--frequency-by", frequencies});
  if (waves.arrays.mesh.empty()) return files;
  for (UsedFile& file : files_of_mesh("--field-mesh", waves.arrays.mesh)) {
    files.push_back(std::move(file));
  }
  return files;
}

void check_files(const std::vector<UsedFile>& inputs, const std::vector<UsedFile>& outputs) {
  const Inputs known(inputs);
  std::map<fs::path, const UsedFile*> written;
  for (const UsedFile& output : outputs) {
    if (is_device(output.path)) continue;
    const auto refuse = [&](const std::string& reason) {
      throw CLI::ValidationError(output.option, "'" + output.path.string() + "' " + reason);
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
    throw CLI::ValidationError(option, "'" + path + "' is no name of a report; end it in .json");
  }
  check_output_path(path);
}

}  // namespace brindle::tool
