/// Reports of runs, for people and for programs.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/crease_slip.h"
#include "brindle/pattern_of.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/samples.h"
#include "brindle/yielding_frequency.h"

namespace brindle {

/// How far frequencies have changed within their tolerance.
struct FrequencyReport {
  FrequencyChange change;
  double spacing_error_wanted_mean = 0;
  std::optional<std::size_t> branches_in_calm;
};

/// Nothing where there was no slack.
std::optional<FrequencyReport> frequency_report(const std::optional<FrequencyChange>& change,
                                                const PatternQuality& quality);

nlohmann::ordered_json to_json(const FrequencyReport& report);

/// A line for people.
void print_frequency(std::ostream& out, const FrequencyReport& report);

/// The figures of a texture beside those of its stripes along the field.
struct TextureReport {
  double energy_v = 0;
  std::size_t branches_u = 0, branches_v = 0;
  TextureSeams seams;
  TextureQuality quality;
};

/// How a pattern follows another one.
struct FollowedReport {
  std::string previous;  ///< its file
  float lambda = 0;
  std::string_view matched_by;                  ///< name of the Matching
  std::size_t vertices_unmatched = 0;           ///< waves without a last phase
  double phase_step = 0;                        ///< how far phases moved on average, in radians
  std::optional<double> field_turned_deg = {};  ///< how far a smooth field turned on average
};

/// The figures of one run.
struct Report {
  nlohmann::ordered_json invocation = nlohmann::ordered_json::object();  ///< as `invocation_of`
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t crease_vertices = 0;      ///< more than `vertices`, at creases
  std::optional<CreaseSlip> slip = {};  ///< along these
  std::size_t vertices_joined = 0;      ///< with others at their place, when the file was read
  Solver solver = Solver::multilevel;
  int threads = 0;
  int iterations = 0;
  double energy = 0;
  PatternQuality quality;
  StripeMilliseconds milliseconds;
  double field_milliseconds = 0;
  std::optional<double> draw_milliseconds;  ///< if there were pictures
  std::string picture_quality;              ///< of these
  WaveReport waves;
  std::optional<std::size_t> field_rows_nonfinite;    ///< of a field file or array
  nlohmann::ordered_json device = {{"kind", "cpu"}};  ///< as Device::description gives it
  std::optional<TextureReport> texture;
  std::optional<TextureQuality> cross;  ///< of a cross field, whose other figures are those of both
                                        ///< waves together
  std::optional<FollowedReport> followed;
  nlohmann::ordered_json making;               ///< keys of MakingFigures; null if there are none
  std::string making_lines;                    ///< the same for people
  std::optional<FrequencyReport> frequency;    ///< with slack
  std::optional<FrequencyReport> frequency_v;  ///< the same of a texture's stripes across the field
};

/// `prepared` is of `surface`.
Report make_report(const Surface& surface, const PreparationFigures& prepared,
                   const StripePattern& pattern, Solver solver);

/// The same of a texture; times are those of both patterns together.
Report make_report(const Surface& surface, const PreparationFigures& prepared,
                   const TexturePattern& texture, Solver solver);

Report make_report(const Surface& surface, const PreparationFigures& prepared,
                   const CrossTexture& texture, Solver solver);

/// The same of any pattern, with the figures of its making.
Report make_report(const Surface& surface, const PreparationFigures& prepared,
                   const PatternResult& pattern, Solver solver);

/// "mesh" or "points".
std::string_view kind_of(const Mesh& mesh);

/// How dense the waves are and how many are missing, for any report.
nlohmann::ordered_json to_json(const WaveReport& waves,
                               const std::optional<std::size_t>& field_rows_nonfinite);

/// Keys of a smoothed field, except its number of singularities, which every report has.
nlohmann::ordered_json to_json(const FieldDetailFigures& detail);

/// How evenly samples lie, for the key "nearest_neighbour".
nlohmann::ordered_json to_json(const SampleSpacing& spacing);

/// A line for people on a `Device::description`; empty for the processor.
std::string device_line(const nlohmann::ordered_json& description);

/// Lines for people about the waves.
void print_waves(std::ostream& out, const WaveReport& waves);

/// Without triangles there are no branches and singularities to count: those keys are left out.
nlohmann::ordered_json to_json(const Report& report);

/// A few lines for people.
void print_report(std::ostream& out, const Report& report);

/// One row a report.
void print_table(std::ostream& out, const std::vector<Report>& reports);

/// Why there are no curves, a line; `short_curves` were left out.
std::string why_no_curves(const std::string& family, std::size_t short_curves);

}  // namespace brindle
