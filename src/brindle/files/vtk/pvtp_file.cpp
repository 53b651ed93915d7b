#include "brindle/files/vtk/pvtp_file.h"

#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

#ifdef BRINDLE_HAS_VTK
#include <pugixml.hpp>
#endif

namespace brindle {
namespace {

#ifdef BRINDLE_HAS_VTK
std::vector<PieceArray> announced_arrays(const pugi::xml_node& element) {
  std::vector<PieceArray> arrays;
  for (const char* kind : {"PDataArray", "DataArray"}) {
    for (const pugi::xml_node& array : element.children(kind)) {
      // String arrays are not supported.
      if (std::string_view(array.attribute("type").value()) == "String") continue;
      arrays.push_back(
          {array.attribute("Name").value(), array.attribute("NumberOfComponents").as_int(1)});
    }
  }
  return arrays;
}

pugi::xml_node surface_of(const InputFile& file, const pugi::xml_document& document) {
  const pugi::xml_node root = document.child("VTKFile");
  if (!root) file.fail_whole("is no VTK file: it has no element 'VTKFile'; export it again");
  const pugi::xml_node surface = root.child("PPolyData");
  if (surface) return surface;
  file.fail_whole("holds " + in_quotes(root.attribute("type").value()) +
                  ", not PPolyData; in ParaView, apply the filter Extract Surface and save its "
                  "result as .pvtp");
}

PieceList piece_list(InputFile& file, const std::filesystem::path& path) {
  const auto size = static_cast<std::size_t>(file.remaining());
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(file.take(size), size);
  if (!parsed) {
    file.fail_whole("is no XML (" + std::string(parsed.description()) +
                    "); it is damaged or truncated, copy or export it again");
  }
  const pugi::xml_node surface = surface_of(file, document);
  PieceList list;
  list.points = announced_arrays(surface.child("PPointData"));
  list.cells = announced_arrays(surface.child("PCellData"));
  list.global_ids = surface.child("PPointData").attribute("GlobalIds").value();
  for (const pugi::xml_node& piece : surface.children("Piece")) {
    const std::string source = piece.attribute("Source").value();
    if (source.empty()) file.fail_whole("has a Piece without its 'Source'; export it again");
    list.pieces.push_back(path.parent_path() / source);
  }
  if (list.pieces.empty()) file.fail_whole("names no piece ('Piece'); export it again");
  return list;
}
#endif

void check_announced(const std::filesystem::path& piece, const std::vector<PieceArray>& announced,
                     std::span<const DataArray> arrays, const std::string& of) {
  for (const PieceArray& expected : announced) {
    const DataArray* array = find_array(arrays, expected.name);
    if (array && array->components == expected.components) continue;
    const std::string lacks =
        array ? "has " + std::to_string(array->components) + " components" : "is missing";
    throw Error(
        shown(piece.string()) + ": array " + in_quotes(expected.name) + " of " + of + " " + lacks +
        ", unlike in the other pieces; the pieces are not of one export, export them again");
  }
}

}  // namespace

#ifdef BRINDLE_HAS_VTK
PieceList read_pvtp(const std::filesystem::path& path) {
  InputFile file(path);
  return piece_list(file, path);
}
#else
PieceList read_pvtp(const std::filesystem::path& path) {
  throw Error(shown(path.string()) +
              ": this build cannot read .pvtp files; configure with -DBRINDLE_VTK=ON");
}
#endif

void check_piece_arrays(const std::filesystem::path& piece, const PieceList& list,
                        const DataArrays& arrays) {
  check_announced(piece, list.points, arrays.points, "points");
  check_announced(piece, list.cells, arrays.cells, "cells");
}

}  // namespace brindle
