/// Rejects options that have no effect or contradict each other, for command lines and Python.
/// Options are named as in the tool.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/error.h"
#include "brindle/option_table.h"
#include "brindle/pattern_of.h"

namespace brindle {

/// A rejected option; what() is "--name: why".
class RefusedOption : public Error {
 public:
  RefusedOption(const std::string& option, const std::string& why)
      : Error(option + ": " + why), option_(option), why_(why) {}
  const std::string& option() const { return option_; }
  const std::string& why() const { return why_; }

 private:
  std::string option_, why_;
};

/// The first table row of "--name", for any job, and the first one of this kind. Throws Error if
/// there is none.
const OptionInfo& row_of(const std::string& option);
const OptionInfo& row_of(const std::string& option, OptionKind kind);

/// Whether an option such as "--epsilon" was given.
using IsGiven = std::function<bool(const std::string& option)>;

/// Throws RefusedOption for the first of `options` that was given, since it has no effect, for the
/// reason `why`. All functions below throw RefusedOption.
void refuse_given(const IsGiven& given, const std::vector<std::string>& options,
                  std::string_view why);

/// Rejects the job's options that MPI ranks do not have.
void check_one_process(const IsGiven& given, PatternJob job);

/// The values that a numeric or choice option accepts: "a finite number above zero".
std::string taken_by(const OptionInfo& info);

/// The reason for rejecting a value: "expected a finite number above zero, got '0'".
std::string unlike(const OptionInfo& info, const std::string& written);

/// Throws RefusedOption for a number outside the range of the first row of that name. `written` is
/// the number as given; default: as printed.
void check_number(const std::string& option, double value, const std::string& written);
void check_number(const std::string& option, double value);

/// The same for a word that is not one of the option's choices.
void check_choice(const std::string& option, const std::string& word);

/// Rejects options of solvers other than the chosen one.
void check_solver_options(const IsGiven& given, Solver solver, int cycles);

/// Rejects --avoid-branches without spacing tolerance.
void check_avoid_branches(const IsGiven& given, bool yields);

/// Rejects options of patterns that follow another one, or of those that do not.
void check_following(const IsGiven& given, bool follows, Solver solver);

/// Rejects fabrication options that contradict each other or the solver.
void check_fabrication(const FabricationOptions& options, Solver solver);

/// Rejects anchor options of a smooth field that have no effect at these weights.
void check_smooth_field(const IsGiven& given, float curvature_anchor, float feature_anchor);

/// The requested smoothing of a field and of frequencies, and what it applies to.
struct SmoothingRequest {
  float periods = 0;            ///< --field-smoothing
  float frequency_periods = 0;  ///< --frequency-smoothing
  bool measured = false;        ///< the field is measured data
  bool cross = false;
  bool varies = false;  ///< the frequency may vary by vertex
};
void check_field_smoothing(const IsGiven& given, const SmoothingRequest& wanted);

/// The reason for rejecting --frequency-smoothing.
inline constexpr const char* kSameFrequency =
    "the frequency is the same everywhere; it is for frequencies of arrays and files";

/// Rejects options that need triangles, for points.
void check_triangle_options(const IsGiven& given);
void check_fabrication_on_points(const IsGiven& given);

/// Rejects windings and anchored boundaries, for textures and cross fields.
void check_fabrication_of_textures(const IsGiven& given);

void check_min_distance_on_points(float min_distance);

/// Rejects views of branches and angle errors, which points and crosses do not have.
void check_view_of_points(bool shows_stripes);
void check_view_of_crosses(bool shows_stripes);

/// Rejects built-in tiles without 90-degree symmetry.
void check_tile_of_crosses(const std::string& name);

}  // namespace brindle
