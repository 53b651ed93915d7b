/// Mesh files of what `brindle stripe` has made, with all that the input's file says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "brindle/cross_cover.h"
#include "brindle/data_arrays.h"
#include "cli/job_listener.h"
#include "input/preparation.h"
#include "outputs/carried_arrays.h"
#include "pictures/picture.h"
#include "pictures/stripe_result.h"

namespace brindle::tool {

/// What comes with a surface from its file and goes along into others.
struct InputData {
  DataArrays arrays;                       ///< a row per vertex, and per triangle
  std::vector<std::int64_t> original_ids;  ///< `Preparation`
  std::vector<Index> partners;             ///< `Preparation`
  float turn_deg = 0;                      ///< `PreparationFigures`
  FieldSupport support = {};               ///< `PreparationFigures`
};

/// Takes it out of `prepared`.
InputData take_input_data(Preparation& prepared);

/// The same on the surface of a cross texture (`CrossTexture`), of a surface of those triangles.
InputData on_cross_texture(const InputData& data, std::span<const Triangle> triangles,
                           const CrossCover& cover);

/// What a mesh file is written from.
struct MadeMesh {
  const Surface& surface;
  const StripeResult& result;
  const InputData& data;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  bool uv = false;  ///< texture coordinates also without a texture
};

/// Whether this mesh file holds values of triangles.
bool holds_cells(const std::filesystem::path& path);

/// Notes which of the input's arrays the file cannot hold. Without triangles, the file holds points
/// with normals.
void write_made_mesh(const std::filesystem::path& path, const MadeMesh& made,
                     const PictureOptions& picture, JobListener& listener);

}  // namespace brindle::tool
