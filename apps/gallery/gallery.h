/// The gallery: items that show what patterns are good for. Each is a generator of data and the
/// command lines of the tool that draw pictures of them.
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

/// A picture of an item: the command line that draws it, without the tool's name and its output. In
/// it, "{file=NAME}" is the path of a data file, and "{surface=NAME}", "{field=VALUE}" and
/// "{values=VALUE}" are what users may replace by their own. "{part=NAME}" is a data file that
/// belongs to the item's own surface: with another one, the option whose value it is in is left
/// out. "{own=VALUE}" is left out with its option where "values" are replaced: ranges, thresholds
/// and titles then follow from the data.
/// "{own=--FLAG}" is a flag of that kind.
struct GalleryPicture {
  std::string name;
  std::string what;  ///< one line
  std::string line;
  std::string size = "900x700";  ///< pixels, width and height
  /// Options of the line, without dashes, that are worth changing while one looks.
  std::vector<std::string> live = {};
};

struct GalleryItem {
  std::string name;
  std::string what;  ///< one line
  /// The data. `detail` multiplies the number of edges along a length. Throws Cancelled.
  std::vector<GalleryFile> (*make)(double detail, const Progress& progress);
  std::vector<GalleryPicture> pictures;  ///< one at least; the first is drawn unless told otherwise
};

/// All items, in the order in which help lists them.
const std::vector<GalleryItem>& gallery_items();

/// What stands at the placeholders.
struct GalleryChoice {
  std::string folder;   ///< of the data files
  std::string surface;  ///< instead of the item's own; empty: not
  std::string field;
  std::string values;
};
/// The words of the picture's command line, the command first. Single quotes keep spaces.
std::vector<std::string> filled_words(const GalleryPicture& picture, const GalleryChoice& choice);

/// Whether the picture has a place for "surface", "field" or "values".
bool has_place(const GalleryPicture& picture, std::string_view role);

/// Whether it is one picture, which a session can have: not moving ones of `brindle animate`.
bool is_still_picture(const GalleryPicture& picture);

/// Writes files into a folder that exists. Throws Error if that fails, Cancelled between and in
/// files.
void write_gallery_files(const std::string& folder, std::span<const GalleryFile> files,
                         const Progress& progress = {});

}  // namespace brindle
