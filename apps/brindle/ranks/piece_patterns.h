/// One or two patterns over partitions, for `brindle curves` and `sample`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/communicator.h"
#include "brindle/distributed_pattern.h"
#include "brindle/distributed_stripes.h"
#include "cli/progress_display.h"
#include "ranks/mesh_pieces.h"
#include "ranks/piece_waves.h"

namespace brindle::tool {

struct PatternArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SolvingOptions solving;
  std::size_t plan_below = DistributedOptions().plan_below;
  std::optional<float> stripes_v;    ///< along the diagonal; U's frequency if neither is given
  std::optional<float> frequency_v;  ///< stripes per unit length
  std::string output;                ///< empty: none
  std::string report;                ///< .json; empty: none
  bool quiet = false;
};

/// All options; `what` is the help of --output, `files` its metavariable.
void add_pattern_options(CLI::App& command, PatternArguments& arguments, const std::string& what,
                         const std::string& files);

/// Whether --output is a .pvtp, for which every rank writes a piece.
bool writes_pieces(const PatternArguments& arguments);

/// Throws CLI::ValidationError for options without effect and for conflicting files, Error on all
/// ranks if a file cannot be written.
void check_pattern_options(const CLI::App& command, const PatternArguments& arguments,
                           Communicator& ranks);

/// A solved pattern of a partition.
struct SolvedPattern {
  WaveSet waves;                      ///< with the chosen frequencies
  FrequencyField frequencies_wanted;  ///< the requested ones if different; else empty
  std::vector<Complex> z;
  double energy = 0;
  PatternQuality quality;
  std::optional<FrequencyChange> frequency_change;  ///< with a spacing tolerance
};

/// With a spacing tolerance: adds the change of frequencies as `name`.
void add_frequency_change(const SolvedPattern& solved, const char* name,
                          nlohmann::ordered_json& json);

struct PiecePatterns {
  ReadPiece read;
  std::optional<DistributedSurface> surface;
  WaveReport figures;
  std::optional<std::size_t> field_rows_nonfinite;
  std::optional<SolvedPattern> u, v;
  /// Milliseconds.
  double load = 0, field = 0, topology = 0, frequency = 0, couple = 0, solve = 0, pattern = 0;

  PiecePattern piece(const SolvedPattern& solved, const PatternArguments& arguments) const {
    return {*surface, solved.waves, solved.z, arguments.solving.stripes.phase_shift};
  }
};

/// Collective. Reads and solves the requested patterns; V is U turned by 90 degrees.
PiecePatterns make_piece_patterns(Communicator& ranks, const PatternArguments& arguments,
                                  bool with_u, bool with_v, ProgressDisplay& display);

/// Collective. Keys of reports: surface, waves, traffic and times.
nlohmann::ordered_json to_json(Communicator& ranks, const PiecePatterns& patterns,
                               double extract_milliseconds);

/// On rank 0. Writes the invocation and the report's keys.
void write_pattern_report(const CLI::App& command, const PatternArguments& arguments,
                          const nlohmann::ordered_json& report);

/// On rank 0: a line of text about ranks.
void print_pattern_ranks(std::ostream& out, const nlohmann::ordered_json& report);

}  // namespace brindle::tool
