/// What `brindle curves` says of its curves.
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

/// A figure of curves: decided once for reports and for windows.
struct CurveFigure {
  std::string key;               ///< in reports; "ends.branch" is "branch" of the object "ends"
  std::string words;             ///< for people; empty: it is for reports alone
  nlohmann::ordered_json value;  ///< a number, as reports have it
  double scale = 1;              ///< for people: 100 of what they see in per cent
  bool if_any = false;           ///< people see it only where it is not zero
};

/// All figures of a family, in the order of its report, but those of windings and of frequencies
/// that yield.
std::vector<CurveFigure> figures_of(const CurveFamily& family);

/// Why curves end, for the key "ends", and as a line for people.
using CurveEnds = std::array<std::size_t, kCurveEndKinds>;
nlohmann::ordered_json ends_to_json(const CurveEnds& ends);
std::string line_of_ends(const CurveEnds& ends);

/// The keys of what became of ends and points: "joined_ends", "ends_at_neighbours", "trimmed_ends",
/// "trimmed_away", "smooth_forks" and "largest_move".
void add_ends(const StripeCurves& curves, nlohmann::ordered_json& json);

/// Lines for people about curves of which ends were joined or trimmed, which were left out, and
/// which jog, each behind `indent`; empty if there is nothing to say.
struct CurveRemarks {
  const StripeCurves& curves;
  std::size_t short_curves = 0, jogs = 0;
};
std::string lines_of(const CurveRemarks& remarks, const std::string& indent);

/// For the key "lengths".
nlohmann::ordered_json to_json(const CurveLengths& lengths);

/// The keys "spacing" and "gaps"; with slack (`yields`) also against other frequencies.
void add_spacing(const CurveSpacing& spacing, bool yields, nlohmann::ordered_json& json);

nlohmann::ordered_json to_json(const CurveFamily& family);

/// What a report is of; all of it lives elsewhere.
struct ReportedCurves {
  const Surface& surface;
  const PreparationFigures& prepared;
  std::span<const CurveFamily> families;
  bool yields = false;  ///< frequencies do
  double edges_milliseconds = 0;
  std::optional<double> draw_milliseconds = {};
};
nlohmann::ordered_json to_json(const ReportedCurves& curves, const PictureOptions& picture);
nlohmann::ordered_json to_json(const CurvesJob& job, const PictureOptions& picture);

/// The same for people.
void print(std::ostream& out, const CurvesJob& job);

}  // namespace brindle::tool
