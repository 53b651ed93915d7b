/// The gallery: examples with generated data. Each item has a generator of data and the command
/// lines that draw its pictures.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// A file of an item's data: a mesh with arrays (.vtp), or a text.
struct GalleryFile {
  std::string name;
  Mesh mesh;
  DataArrays arrays;
  std::string text;
};

/// A picture of an item: its command line without the tool's name and the output. "{file=NAME}" is
/// the path of a data file; users may replace "{surface=NAME}", "{field=VALUE}" and
/// "{values=VALUE}". "{part=NAME}" is a data file of the item's own surface, dropped with its
/// option for another surface. "{own=VALUE}" is dropped with its option if "values" are replaced:
/// ranges, thresholds and titles then follow from the data. "{own=--FLAG}" is such a flag.
struct GalleryPicture {
  std::string name;
  std::string what;  ///< one line
  std::string line;
  std::string size = "900x700";  ///< pixels, width and height
  /// Options of the line, without dashes, for live controls.
  std::vector<std::string> live = {};
};

struct GalleryItem {
  std::string name;
  std::string what;  ///< one line
  /// Makes the data. `detail` multiplies the number of edges along a length. Throws Cancelled.
  std::vector<GalleryFile> (*make)(double detail, const Progress& progress);
  std::vector<GalleryPicture> pictures;  ///< at least one; the first is the default
};

/// All items, in the order in which help lists them.
const std::vector<GalleryItem>& gallery_items();

/// Values of the placeholders.
struct GalleryChoice {
  std::string folder;   ///< of the data files
  std::string surface;  ///< instead of the item's own; empty: none
  std::string field;
  std::string values;
};
/// The words of the picture's command line, the command first. Single quotes keep spaces.
std::vector<std::string> filled_words(const GalleryPicture& picture, const GalleryChoice& choice);

/// Whether the picture has a placeholder "surface", "field" or "values".
bool has_place(const GalleryPicture& picture, std::string_view role);

/// Whether it is a still picture, for sessions: not one of `brindle animate`.
bool is_still_picture(const GalleryPicture& picture);

/// Writes files into an existing folder. Throws Error on failure, and Cancelled.
void write_gallery_files(const std::string& folder, std::span<const GalleryFile> files,
                         const Progress& progress = {});

}  // namespace brindle
