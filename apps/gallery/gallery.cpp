#include "gallery/gallery.h"

#include <filesystem>
#include <optional>

#include "brindle/base/output_file.h"
#include "brindle/files.h"
#include "gallery/items.h"

namespace brindle {
namespace {

/// A placeholder of a word: "{role=value}", the first one from `from` on.
struct Place {
  std::size_t begin = 0, end = 0;
  std::string role, value;
};

std::optional<Place> place_in(const std::string& word, std::size_t from) {
  const std::size_t begin = word.find('{', from);
  const std::size_t equals = word.find('=', begin);
  const std::size_t end = word.find('}', equals);
  if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
  return Place{begin, end + 1, word.substr(begin + 1, equals - begin - 1),
               word.substr(equals + 1, end - equals - 1)};
}

/// Splits at spaces outside single quotes.
std::vector<std::string> words_in(const std::string& line) {
  std::vector<std::string> words;
  bool inside = false, begun = false;
  for (const char c : line) {
    if (c == '\'') {
      inside = !inside;
    } else if (c == ' ' && !inside) {
      begun = false;
      continue;
    }
    if (!begun) words.emplace_back();
    begun = true;
    if (c != '\'') words.back() += c;
  }
  return words;
}

bool is_file(const std::string& value) {
  return value.ends_with(".vtp") || value.ends_with(".csv");
}

std::string filled(const Place& place, const GalleryChoice& choice) {
  if (place.role == "surface" && !choice.surface.empty()) return choice.surface;
  if (place.role == "field" && !choice.field.empty()) return choice.field;
  if (place.role == "values" && !choice.values.empty()) return choice.values;
  if (!is_file(place.value)) return place.value;
  return (std::filesystem::path(choice.folder) / place.value).string();
}

/// Whether it belongs to data that the user replaced.
bool is_left_out(const Place& place, const GalleryChoice& choice) {
  return (place.role == "part" && !choice.surface.empty()) ||
         (place.role == "own" && !choice.values.empty());
}

/// Empty for a word that is left out. What is left out within a word leaves the rest.
std::string filled(std::string word, const GalleryChoice& choice) {
  std::size_t from = 0;
  while (const auto place = place_in(word, from)) {
    const bool left_out = is_left_out(*place, choice);
    if (left_out && place->begin == 0) return "";
    const std::string value = left_out ? "" : filled(*place, choice);
    word.replace(place->begin, place->end - place->begin, value);
    from = place->begin + value.size();
  }
  return word;
}

}  // namespace

const std::vector<GalleryItem>& gallery_items() {
  static const std::vector<GalleryItem> items = {
      liver_item(),    nested_item(), vortices_item(), aneurysm_item(), molecule_item(),
      hatching_item(), glyphs_item(), crosses_item(),  rough_item(),    giant_item()};
  return items;
}

std::vector<std::string> filled_words(const GalleryPicture& picture, const GalleryChoice& choice) {
  std::vector<std::string> words;
  for (const std::string& word : words_in(picture.line)) {
    const std::string text = filled(word, choice);
    if (text.empty()) {
      words.pop_back();  // the option of this value
    } else {
      words.push_back(text);
    }
  }
  return words;
}

bool has_place(const GalleryPicture& picture, std::string_view role) {
  return picture.line.find("{" + std::string(role) + "=") != std::string::npos;
}

bool is_still_picture(const GalleryPicture& picture) {
  return !picture.line.starts_with("animate ");
}

void write_gallery_files(const std::string& folder, std::span<const GalleryFile> files,
                         const Progress& progress) {
  const auto share = [&](std::size_t done) {
    return static_cast<double>(done) / static_cast<double>(files.size());
  };
  for (std::size_t i = 0; i < files.size(); ++i) {
    const GalleryFile& file = files[i];
    const std::filesystem::path path = std::filesystem::path(folder) / file.name;
    if (file.text.empty()) {
      write_mesh(path, file.mesh, file.arrays.points, file.arrays.cells,
                 progress.part(share(i), share(i + 1)));
    } else {
      write_file(path, [&](OutputStream& out) { out << file.text; });
    }
  }
}

}  // namespace brindle
