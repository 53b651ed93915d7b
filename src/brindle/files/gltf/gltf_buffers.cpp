#include "brindle/files/gltf/gltf_buffers.h"

#ifdef BRINDLE_HAS_JSON

#include <optional>

#include "brindle/base/base64.h"
#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/gltf/percent_decoded.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDataUri = "data:";

/// Where a URI that is no data leads in the folder of the .gltf; nothing if it leads out of it.
std::optional<fs::path> file_in_folder(const fs::path& gltf, const std::string& uri) {
  const std::string name = percent_decoded(uri);
  if (name.find('\0') != std::string::npos || name.find("://") != std::string::npos) {
    return std::nullopt;
  }
  const fs::path inside = fs::path(name).lexically_normal();
  if (inside.is_absolute() || inside.empty() || *inside.begin() == "..") return std::nullopt;
  return gltf.parent_path() / inside;
}

}  // namespace

std::vector<fs::path> gltf_buffer_files(const fs::path& gltf) {
  std::vector<fs::path> paths;
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(whole_input(gltf, "a mesh file"), nullptr, false);
  } catch (const Error&) {
    return paths;
  }
  if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array()) return paths;
  for (const auto& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const std::string uri = buffer["uri"];
    if (uri.starts_with(kDataUri)) continue;
    if (auto file = file_in_folder(gltf, uri)) paths.push_back(*std::move(file));
  }
  return paths;
}

void GltfBuffers::fail(const std::string& what) const {
  throw Error(shown(path_.string()) + ": " + what);
}

const std::string& GltfBuffers::buffer(std::uint64_t index) {
  const nlohmann::json& described = document_.json["buffers"][index];
  const std::string& content = content_of(described);
  const auto promised = described["byteLength"].get<std::uint64_t>();
  if (content.size() < promised) {
    fail("is truncated: a buffer has " + std::to_string(content.size()) + " bytes instead of " +
         std::to_string(promised) + "; export it again");
  }
  return content;
}

const std::string& GltfBuffers::content_of(const nlohmann::json& buffer) {
  const auto uri = buffer.find("uri");
  if (uri != buffer.end()) {
    if (!uri->is_string()) fail("is a damaged glTF file, export it again: 'uri' is no text");
    return content_of_uri(uri->get_ref<const std::string&>());
  }
  const auto [entry, is_new] = contents_.try_emplace("");
  if (is_new) {
    // A GLB's own buffer may lack its padding, which buffers count.
    entry->second = document_.data + std::string(3, '\0');
    size_ += entry->second.size();
  }
  return entry->second;
}

const std::string& GltfBuffers::content_of_uri(const std::string& uri) {
  const auto [entry, is_new] = contents_.try_emplace(uri);
  std::string& content = entry->second;
  if (!is_new) return content;
  if (uri.starts_with(kDataUri)) {
    const std::size_t comma = uri.find(',');
    const bool base64 = comma != std::string::npos && uri.substr(0, comma).ends_with(";base64");
    auto bytes = base64 ? base64_decoded(std::string_view(uri).substr(comma + 1)) : std::nullopt;
    if (!bytes) fail("is a damaged glTF file, export it again: its data are not in base64");
    content = *std::move(bytes);
  } else {
    const std::optional<fs::path> file = file_in_folder(path_, uri);
    if (!file) {
      fail("names the data file " + in_quotes(uri) +
           ", which is not in its own folder, so brindle does not read it; put both into one "
           "folder and name it without a path");
    }
    try {
      content = whole_input(*file, "its data");
    } catch (const Error& error) {
      fail(std::string("needs a data file beside it: ") + error.what());
    }
  }
  size_ += content.size();
  return content;
}

}  // namespace brindle

#else

namespace brindle {

std::vector<std::filesystem::path> gltf_buffer_files(const std::filesystem::path&) { return {}; }

}  // namespace brindle

#endif  // BRINDLE_HAS_JSON
