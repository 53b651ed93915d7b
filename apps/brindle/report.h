/// What a run reports, for people and for programs.
#pragma once

#include <iosfwd>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/pipeline/stripe_pattern.h"
#include "preparation.h"

namespace brindle::tool {

/// The figures of one run.
struct Report {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  Solver solver = Solver::multilevel;
  int threads = 0;
  int iterations = 0;
  double energy = 0;
  PatternQuality quality;
  StripeMilliseconds milliseconds;
  nlohmann::ordered_json device = {{"kind", "cpu"}};  ///< as Device::description gives it
};

Report make_report(const Preparation& prepared, const StripePattern& pattern, Solver solver);

nlohmann::ordered_json to_json(const Report& report);

/// A few lines for people.
void print_report(std::ostream& out, const Report& report);

/// One row a report.
void print_table(std::ostream& out, const std::vector<Report>& reports);

}  // namespace brindle::tool
