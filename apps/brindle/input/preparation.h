/// The stages that come before the stripes, the same for every command.
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
#include "input/viewpoint.h"
#include "input/wave_options.h"

namespace brindle::tool {

struct KeptPattern;

/// A surface with waves, and what it took.
struct Preparation : PreparationFigures {
  Surface surface;
  WaveSet waves;
  FrequencyField frequencies_v;  ///< of crossing stripes; empty: those of `waves`
  DataArrays arrays;    ///< of the mesh's file: a row per vertex of the surface, and per triangle
  bool points = false;  ///< the surface has no triangles
  /// For every vertex of the mesh's file the vertex that triangles use in its place; empty if none
  /// was joined with another. What rows of field files may stand for.
  std::vector<Index> vertex_of_row;
  /// The same for every vertex of the surface, up to the last that was joined: what files say of a
  /// vertex is what its partner has.
  std::vector<Index> partners;
  /// The number in the file or shape of every vertex of the surface: of several that were joined
  /// to one, the first; -1 of those that were added.
  std::vector<std::int64_t> original_ids;
  DirectionField kept_field;  ///< before it was turned, if that of a next step may go on from it
  /// What the smooth field went on from, if that was read from a file.
  std::shared_ptr<const KeptPattern> previous = nullptr;
};

/// Finds what the field of a surface, which has no waves yet, goes on from.
using FindLastDirections = std::function<LastDirections(Preparation& surface)>;

/// `Preparation::original_ids` of a surface that was read or made.
std::vector<std::int64_t> original_ids_of(const LoadedSurface& loaded);

/// Loads the mesh and makes its waves. Notes what had to be repaired and what is
/// probably not meant. Pictures, if there are any, are taken from `viewpoint`. Throws Error if no
/// vertex has a wave, and what `find_last` throws, which is asked for fields that go on
/// from a last one.
Preparation prepare(const SurfaceOptions& surface, const WaveOptions& waves, JobListener& listener,
                    const std::optional<Viewpoint>& viewpoint = std::nullopt,
                    const FindLastDirections& find_last = {});

/// The stages of that, in their order, as `JobListener::stage` hears of them.
std::vector<JobStage> preparation_stages(const SurfaceOptions& surface);

/// Throws CLI::ValidationError if the waves need arrays that the surface cannot have.
void check_own_arrays(const SurfaceOptions& surface, const WaveOptions& waves);

/// The same in two steps: a surface without waves, and the waves of such a surface, which may be
/// made again and again.
Preparation prepare_surface(const SurfaceOptions& surface, JobListener& listener);

/// Waves on a surface, and what they took.
struct PreparedWaves {
  WaveSet waves;
  FrequencyField frequencies_v;
  WaveReport figures;
  std::optional<std::size_t> field_rows_nonfinite;
  std::optional<FieldStep> field_step;
  float turn_deg = 0;  ///< by which waves are turned from their field
  double field_milliseconds = 0;
  FieldSupport support;       ///< of smoothed waves
  DirectionField seen_field;  ///< as WavesOfField has it
};

/// Those of a base field that is there already, whose time does not count.
PreparedWaves prepare_waves(const Preparation& prepared, const SurfaceOptions& surface,
                            const WaveOptions& waves, BaseField field, JobListener& listener,
                            const std::optional<Viewpoint>& viewpoint = std::nullopt);

/// The base field for `prepared`, as `make_base_field` makes it.
BaseField prepare_field(const Preparation& prepared, const SurfaceOptions& surface,
                        const WaveOptions& waves, JobListener& listener,
                        const LastDirections& last = {});

/// The waves alone, of a field that is found anew; nothing is noted.
WaveSet waves_afresh(const Preparation& prepared, const SurfaceOptions& surface,
                     const WaveOptions& waves, const std::optional<Viewpoint>& viewpoint);

/// Puts the waves on their surface.
void take_waves(PreparedWaves waves, Preparation& prepared);

/// Measures waves; throws and notes as `prepare` does. `source` says where they come from: "the
/// field of V"; `figures`, what is known of them beside what is measured here.
WaveReport noted_waves(const Surface& surface, const WaveSet& waves, const std::string& source,
                       JobListener& listener, WaveReport figures = {});

}  // namespace brindle::tool
