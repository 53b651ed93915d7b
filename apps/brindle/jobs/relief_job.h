/// `brindle relief`: options, result and report.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/relief.h"
#include "jobs/stripe_job.h"
#include "outputs/outputs.h"

namespace brindle::tool {

/// Options of the relief itself.
struct ReliefChoice {
  Length height;
  std::optional<Length> tolerance;
  bool keep_flat = false;
  std::string only;  ///< the faces with the texture, empty: all
  std::optional<Length> inlay;
  bool cut = false;
  Length fill_holes{kFilledHoles, true};

  /// Calls `add("--option", field)` for each option.
  template <class Add>
  void visit(const Add& add) {
    add("--height", height);
    add("--tolerance", tolerance);
    add("--keep-flat", keep_flat);
    add("--only", only);
    add("--inlay", inlay);
    add("--cut", cut);
    add("--fill-holes", fill_holes);
  }
};

/// `pattern` has the options of the texture.
struct ReliefArguments {
  StripeArguments pattern;
  ReliefChoice relief;
};

void add_relief_options(CLI::App& command, ReliefArguments& arguments);

/// All input files.
std::vector<UsedFile> relief_inputs(const ReliefArguments& arguments);

/// Throws CLI::ValidationError for options without effect and wrong values of --only. Reads no
/// files.
void check_relief_options(const CLI::App& command, const ReliefArguments& arguments);

struct ReliefJob : DrawingTime {
  StripeJob texture;
  Relief relief;
  double relief_milliseconds = 0;
};

/// Its stages, in order, for `JobListener`.
std::vector<JobStage> relief_stages(const ReliefArguments& arguments);

/// Throws what the texture and `make_relief` throw, and Error if no face has the texture.
ReliefJob make_relief_job(const ReliefArguments& arguments, JobListener& listener);

nlohmann::ordered_json to_json(const ReliefJob& job);

/// The same as text.
void print(std::ostream& out, const ReliefJob& job);

}  // namespace brindle::tool
