/// The stages that come before the stripes, the same for every command.
#pragma once

#include <cstdint>
#include <vector>

#include "progress_display.h"
#include "surface_options.h"
#include "wave_figures.h"
#include "wave_options.h"

namespace brindle::tool {

/// A surface with waves, and what it took.
struct Preparation {
  Surface surface;
  WaveSet waves;
  FrequencyField frequencies_v;  ///< of crossing stripes; empty: those of `waves`
  WaveFigures figures;           ///< of `waves`
  DataArrays arrays;  ///< of the mesh's file: a row per vertex of the surface, and per triangle
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  bool points = false;                              ///< the surface has no triangles
  /// For every vertex of the mesh's file the vertex that triangles use in its place; empty if none
  /// was joined with another. What rows of field files may stand for.
  std::vector<Index> vertex_of_row;
  /// The same for every vertex of the surface, up to the last that was joined: what files say of a
  /// vertex is what its partner has.
  std::vector<Index> partners;
  /// The number in the file or shape of every vertex of the surface: of several that were joined
  /// to one, the first; -1 of those that were added.
  std::vector<std::int64_t> original_ids;
  std::size_t vertices_joined = 0;   ///< with others at their place
  double load_milliseconds = 0;      ///< reading or making the mesh and its field
  double topology_milliseconds = 0;  ///< neighbourhood and normals
};

/// Loads the mesh and makes its waves. Notes on the display what had to be repaired and what is
/// probably not meant. Throws Error if no vertex has a wave.
Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves,
                    ProgressDisplay& display);

/// Measures waves; throws and notes as `prepare` does. `source` says where they come from: "the
/// field of V"; `missing`, why there are none where there are none.
WaveFigures noted_waves(const Surface& surface, const WaveSet& waves, const std::string& source,
                        ProgressDisplay& display, const MissingWaves& missing = {});

}  // namespace brindle::tool
