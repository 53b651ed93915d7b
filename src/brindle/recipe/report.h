/// Reports of runs, as text and JSON.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/pattern_of.h"
#include "brindle/quality.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/samples.h"
#include "brindle/spacing_tolerance.h"

namespace brindle {

/// Changes of frequencies within the spacing tolerance.
struct FrequencyReport {
  FrequencyChange change;
  double spacing_error_wanted_mean = 0;
  std::optional<std::size_t> branches_in_avoided_area;
};

/// Nullopt without slack.
std::optional<FrequencyReport> frequency_report(const std::optional<FrequencyChange>& change,
                                                const PatternQuality& quality);

nlohmann::ordered_json to_json(const FrequencyReport& report);

/// A line of text.
void print_frequency(std::ostream& out, const FrequencyReport& report);

/// Metrics of a texture, in addition to those of its stripes along the field.
struct TextureReport {
  double energy_v = 0;
  std::size_t branches_u = 0, branches_v = 0;
  TextureSeams seams;
  TextureQuality quality;
};

/// Relation of a pattern to the one that it follows.
struct FollowedReport {
  std::string previous;  ///< its file
  float lambda = 0;
  std::string matched_by;                       ///< name of the Matching
  std::size_t vertices_unmatched = 0;           ///< waves without a last phase
  double phase_step = 0;                        ///< mean change of phases, in radians
  std::optional<double> field_turned_deg = {};  ///< mean rotation of a smooth field
};

/// The metrics of one run.
struct Report {
  nlohmann::ordered_json invocation = nlohmann::ordered_json::object();  ///< as `invocation_of`
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t crease_vertices = 0;      ///< copies at creases, not counted in `vertices`
  std::optional<CreaseSlip> slip = {};  ///< at creases
  std::size_t vertices_joined = 0;      ///< with others at their position, on loading
  Solver solver = Solver::multilevel;
  int threads = 0;
  int iterations = 0;
  double energy = 0;
  PatternQuality quality;
  StripeMilliseconds milliseconds;
  double field_milliseconds = 0;
  std::optional<double> draw_milliseconds;  ///< if pictures were drawn
  nlohmann::ordered_json picture = {};      ///< keys on the pictures, if there are any
  WaveReport waves;
  std::optional<std::size_t> field_rows_nonfinite;    ///< of a field file or array
  nlohmann::ordered_json device = {{"kind", "cpu"}};  ///< from Device::description
  std::optional<TextureReport> texture;
  std::optional<TextureQuality> cross;  ///< other metrics are of both waves
  std::optional<FollowedReport> followed;
  nlohmann::ordered_json fabrication;        ///< JSON of FabricationMetrics; null if there are none
  std::string fabrication_lines;             ///< the same as text
  std::optional<FrequencyReport> frequency;  ///< with slack
  std::optional<FrequencyReport> frequency_v;  ///< of V in a texture
};

/// `prepared` belongs to `surface`.
Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const StripePattern& pattern, Solver solver);

/// The same for a texture; times are totals of both patterns.
Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const TexturePattern& texture, Solver solver);

Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const CrossTexture& texture, Solver solver);

/// The same for any pattern, with its fabrication metrics.
Report make_report(const Surface& surface, const PreparationMetrics& prepared,
                   const PatternResult& pattern, Solver solver);

/// "mesh" or "points".
std::string_view kind_of(const Mesh& mesh);

/// Density of the waves and number of missing ones, for any report.
nlohmann::ordered_json to_json(const WaveReport& waves,
                               const std::optional<std::size_t>& field_rows_nonfinite);

/// Keys of a smoothed field, except its number of singularities, which every report has.
nlohmann::ordered_json to_json(const FieldSmoothingMetrics& smoothing);

/// Evenness of samples, for the key "nearest_neighbour".
nlohmann::ordered_json to_json(const SampleSpacing& spacing);

/// A line of text on a `Device::description`; empty for the CPU.
std::string device_line(const nlohmann::ordered_json& description);

/// Lines of text on the waves.
void print_waves(std::ostream& out, const WaveReport& waves);

/// Omits the keys on branches and singularities for points without triangles.
nlohmann::ordered_json to_json(const Report& report);

/// A few lines of text.
void print_report(std::ostream& out, const Report& report);

/// One row per report.
void print_table(std::ostream& out, const std::vector<Report>& reports);

/// A line on why there are no curves; `short_curves` were left out.
std::string why_no_curves(const std::string& family, std::size_t short_curves);

// Reports on winding numbers, boundaries and cancelled branches.

/// Most winding numbers in a text report; JSON reports have all.
inline constexpr std::size_t kMostWindings = 12;

/// JSON keys, and lines of text.
void add_to_json(const FabricationMetrics& metrics, nlohmann::ordered_json& json);
std::string lines_of(const FabricationMetrics& metrics);

/// Those lines without the winding numbers: sums that do not add up, rotation of the field and
/// cancelled branches.
std::string remarks_of(const FabricationMetrics& metrics);

}  // namespace brindle
