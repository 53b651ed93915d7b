/// Mesh files of `brindle stripe`, with all arrays of the input.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "brindle/cross_cover.h"
#include "brindle/data_arrays.h"
#include "cli/job_listener.h"
#include "input/preparation.h"
#include "outputs/outputs.h"
#include "pictures/picture.h"
#include "pictures/stripe_result.h"

namespace brindle::tool {

/// Input data that are copied to output files.
struct InputData {
  DataArrays arrays;                       ///< per vertex and per triangle
  std::vector<std::int64_t> original_ids;  ///< `Preparation`
  std::vector<Index> partners;             ///< `Preparation`
  float turn_deg = 0;                      ///< `PreparationMetrics`
  FieldSupport support = {};               ///< `PreparationMetrics`
};

/// Moves it out of `prepared`.
InputData take_input_data(Preparation& prepared);

/// The same for the surface of a cross texture (`CrossTexture`), from a surface with these
/// triangles.
InputData on_cross_texture(const InputData& data, std::span<const Triangle> triangles,
                           const CrossCover& cover);

/// The content of a mesh file.
struct MadeMesh {
  const Surface& surface;
  const StripeResult& result;
  const InputData& data;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  bool uv = false;  ///< texture coordinates even without a texture
};

/// Whether this mesh file can hold triangle arrays.
bool holds_cells(const std::filesystem::path& path);

/// Notes the input arrays that the file cannot hold. Without triangles, writes points with normals.
void write_made_mesh(const std::filesystem::path& path, const MadeMesh& made,
                     const PictureOptions& picture, JobListener& listener);

}  // namespace brindle::tool
