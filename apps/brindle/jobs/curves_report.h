/// The report of `brindle curves`.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "jobs/curves_job.h"

namespace brindle::tool {

/// A metric of curves, shared by reports and windows.
struct CurveMetric {
  std::string key;               ///< in JSON; "ends.branch" is "branch" of the object "ends"
  std::string words;             ///< label in text; empty: JSON only
  nlohmann::ordered_json value;  ///< a number, as reports have it
  double scale = 1;              ///< factor in text: 100 for per cent
  bool if_any = false;           ///< in text only if not zero
};

/// All metrics of a family, in the order of its report, except for windings and the spacing
/// tolerance.
std::vector<CurveMetric> metrics_of(const CurveFamily& family);

/// Counts of reasons why curves end, for the key "ends" and for text.
using CurveEnds = std::array<std::size_t, kCurveEndKinds>;
nlohmann::ordered_json ends_to_json(const CurveEnds& ends);
std::string line_of_ends(const CurveEnds& ends);

/// The keys of changed ends and points: "joined_ends", "ends_at_neighbours", "trimmed_ends",
/// "trimmed_away", "smooth_forks" and "largest_move".
void add_ends(const StripeCurves& curves, nlohmann::ordered_json& json);

/// Lines of text about curves with joined or trimmed ends, left-out curves and jogs, each after
/// `indent`; may be empty.
struct CurveRemarks {
  const StripeCurves& curves;
  std::size_t short_curves = 0, jogs = 0;
};
std::string lines_of(const CurveRemarks& remarks, const std::string& indent);

/// For the key "lengths".
nlohmann::ordered_json to_json(const CurveLengths& lengths);

/// The keys "spacing" and "gaps"; with a spacing tolerance (`yields`) also relative to the other
/// frequencies.
void add_spacing(const CurveSpacing& spacing, bool yields, nlohmann::ordered_json& json);

nlohmann::ordered_json to_json(const CurveFamily& family);

/// The content of a report, by reference.
struct ReportedCurves {
  const Surface& surface;
  const PreparationMetrics& prepared;
  std::span<const CurveFamily> families;
  bool yields = false;  ///< with a spacing tolerance
  double edges_milliseconds = 0;
  std::optional<double> draw_milliseconds = {};
};
nlohmann::ordered_json to_json(const ReportedCurves& curves, const PictureOptions& picture);
nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture);

/// The same as text.
void print(std::ostream& out, const CurvesJob& job);

}  // namespace brindle::tool
