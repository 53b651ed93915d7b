/// Rejections of options that have no effect or contradict each other, for command lines and for
/// Python. Options are named as in the tool.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/error.h"
#include "brindle/option_table.h"
#include "brindle/pattern_of.h"

namespace brindle {

/// An option that is refused; what() is "--name: why".
class RefusedOption : public Error {
 public:
  RefusedOption(const std::string& option, const std::string& why)
      : Error(option + ": " + why), option_(option), why_(why) {}
  const std::string& option() const { return option_; }
  const std::string& why() const { return why_; }

 private:
  std::string option_, why_;
};

/// The first row of the table for "--name", whatever job it is for, and the first one of this kind.
/// Throws Error if there is none.
const OptionInfo& row_of(const std::string& option);
const OptionInfo& row_of(const std::string& option, OptionKind kind);

/// Whether an option was given: "--epsilon".
using IsGiven = std::function<bool(const std::string& option)>;

/// Throws RefusedOption for the first of `options` that was given: it has no effect, for the reason
/// `why`. All functions below throw RefusedOption.
void refuse_given(const IsGiven& given, const std::vector<std::string>& options,
                  std::string_view why);

/// The values that a number or a choice of the table takes: "a finite number above zero".
std::string taken_by(const OptionInfo& info);

/// Why a value is refused: "expected a finite number above zero, got '0'".
std::string unlike(const OptionInfo& info, const std::string& written);

/// Throws RefusedOption for a number that is not in the range of the table's first row of that
/// name. `written` is how it was given; without, as it prints.
void check_number(const std::string& option, double value, const std::string& written);
void check_number(const std::string& option, double value);

/// The same for a word that is none of its choices.
void check_choice(const std::string& option, const std::string& word);

/// Options of solvers other than the chosen one.
void check_solver_options(const IsGiven& given, Solver solver, int cycles);

/// --calm where no frequency yields.
void check_calm(const IsGiven& given, bool yields);

/// Options of a pattern that follows another one, or does not.
void check_following(const IsGiven& given, bool follows, Solver solver);

/// Making options that contradict each other or the solver.
void check_making(const MakingOptions& options, Solver solver);

/// Options of the anchors of a smooth field, which have these weights.
void check_smooth_field(const IsGiven& given, float curvature_anchor, float feature_anchor);

/// The smoothing of a field and of frequencies, and what it is applied to.
struct DetailRequest {
  float periods = 0;            ///< --field-detail
  float frequency_periods = 0;  ///< --frequency-detail
  bool measured = false;        ///< the field was
  bool cross = false;
  bool varies = false;  ///< the frequency may differ from vertex to vertex
};
void check_field_detail(const IsGiven& given, const DetailRequest& wanted);

/// --frequency-detail where it has no effect.
inline constexpr const char* kSameFrequency =
    "the frequency is the same everywhere; it is for frequencies of arrays and files";

/// Options that need triangles, for points.
void check_triangle_options(const IsGiven& given);
void check_making_on_points(const IsGiven& given);
void check_min_distance_on_points(float min_distance);

/// Views of branches and angle errors, which points and crosses do not have.
void check_view_of_points(bool shows_stripes);
void check_view_of_crosses(bool shows_stripes);

/// A built-in tile that does not look the same turned by 90 degrees.
void check_tile_of_crosses(const std::string& name);

}  // namespace brindle
