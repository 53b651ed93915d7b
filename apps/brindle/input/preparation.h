/// The stages before the stripes, common to all commands.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "brindle/recipe/wave_report.h"
#include "cli/job_listener.h"
#include "input/make_waves.h"
#include "input/surface_options.h"
#include "input/vertex_values.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// Lines about recentring and repairs; may be empty.
std::string describe(const LoadedPoints& loaded);
std::string describe(const LoadedMesh& loaded);

/// Reads the points of a file or takes the vertices of a shape. Throws as `load_mesh` does.
LoadedPoints load_points(const SurfaceOptions& options);

/// A loaded mesh.
struct LoadedSurface : LoadedMesh {
  std::size_t own_vertices = 0;  ///< of the file or shape, before those of --subdivide
};

/// Reads or makes the mesh and subdivides it. Throws CLI::ValidationError for a misspelt shape and
/// for --neighbors, Error if a file cannot be read.
LoadedSurface load_mesh(const SurfaceOptions& options, const Progress& progress = {});

struct KeptPattern;

/// A surface with waves, and the time spent.
struct Preparation : PreparationMetrics {
  Surface surface;
  WaveSet waves;
  FrequencyField frequencies_v;  ///< of crossing stripes; empty: those of `waves`
  DataArrays arrays;             ///< of the mesh's file, per vertex and per triangle of the surface
  bool points = false;           ///< the surface has no triangles
  /// The vertex that replaces each vertex of the mesh's file after joining; empty if none were
  /// joined. Field files may have these rows.
  std::vector<Index> vertex_of_row;
  /// The same for the vertices of the surface, up to the last joined one; output files give both
  /// the same values.
  std::vector<Index> partners;
  /// Vertex numbers in the file or shape: of joined vertices, the first; -1 for added vertices.
  std::vector<std::int64_t> original_ids;
  DirectionField kept_field;  ///< before it is turned, if the next step may start from it
  /// The pattern that the smooth field started from, if it was read from a file.
  std::shared_ptr<const KeptPattern> previous = nullptr;
};

/// Finds the field that a surface without waves starts from.
using FindLastDirections = std::function<LastDirections(Preparation& surface)>;

/// `Preparation::original_ids` of a loaded surface.
std::vector<std::int64_t> original_ids_of(const LoadedSurface& loaded);

/// Loads the mesh and makes its waves. Notes repairs and likely mistakes. `viewpoint` is that of
/// pictures, if any. Throws Error if no vertex has a wave, and whatever `find_last` throws, which
/// is called for fields that continue the last one.
Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves, JobListener& listener,
                    const std::optional<Viewpoint>& viewpoint = std::nullopt,
                    const FindLastDirections& find_last = {});

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> preparation_stages(const SurfaceOptions& surface);

/// Throws CLI::ValidationError if the waves need arrays that the surface cannot have.
void check_own_arrays(const SurfaceOptions& surface, const WaveOptions& waves);

/// The same in two steps: a surface without waves, and its waves, which may be recomputed.
Preparation prepare_surface(const SurfaceOptions& surface, JobListener& listener);

/// Waves on a surface, and the time spent.
struct PreparedWaves : FieldMetrics {
  WaveSet waves;
  FrequencyField frequencies_v;
  DirectionField seen_field;  ///< as WavesOfField has it
};

/// Waves of an existing base field, whose time is not included; `subdivided` as WaveReport has it.
PreparedWaves prepare_waves(const WaveSource& source, const WaveOptions& waves,
                            std::optional<int> subdivided, BaseField field, JobListener& listener);
PreparedWaves prepare_waves(const Preparation& prepared, const SurfaceOptions& surface,
                            const WaveOptions& waves, BaseField field, JobListener& listener,
                            const std::optional<Viewpoint>& viewpoint = std::nullopt);

/// The base field for `prepared`, as `make_base_field` makes it.
BaseField prepare_field(const Preparation& prepared, const SurfaceOptions& surface,
                        const WaveOptions& waves, JobListener& listener,
                        const LastDirections& last = {});

/// The waves of a field computed from scratch; makes no notes.
WaveSet waves_afresh(const Preparation& prepared, const SurfaceOptions& surface,
                     const WaveOptions& waves, const std::optional<Viewpoint>& viewpoint);

/// Moves the waves to their surface.
void take_waves(PreparedWaves waves, Preparation& prepared);

/// Throws and notes as `prepare` does. `source` names the origin of the waves: "the field of V";
/// `metrics` has what else is known of them.
WaveReport noted_waves(const WaveMetrics& measured, const std::string& source,
                       JobListener& listener, WaveReport metrics = {});

}  // namespace brindle::tool
