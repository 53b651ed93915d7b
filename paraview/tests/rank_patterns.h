/// Patterns over partitions, and the library's equivalents.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <brindle/corner_phases.h>
#include <brindle/quality.h>
#include <brindle/stripe_pattern.h>

#include "filter_runs.h"
#include "global_numbers.h"
#include "rank_pieces.h"
#include "vtkBrindleStripes.h"

namespace brindle::paraview {

/// A pattern of the whole surface from the ranks' outputs.
inline StripePattern whole_pattern(const Mesh& whole, vtkPolyData& output) {
  StripePattern pattern;
  pattern.waves.positions = whole.positions;
  const Gathered phases(whole.vertex_count(), output, "phase");
  const Gathered directions(whole.vertex_count(), output, "direction");
  const Gathered frequencies(whole.vertex_count(), output, "frequency");
  for (std::size_t v = 0; v < whole.vertex_count(); ++v) {
    const auto& [x, y, z] = directions.values[v];
    pattern.waves.directions.emplace_back(x, y, z);
    const float phase = phases.values[v][0];
    pattern.solution.z.push_back(std::isnan(phase) ? Complex(1) : std::polar(1.0f, phase));
    pattern.waves.frequencies.push_back(frequencies.values[v][0]);
  }
  pattern.corners =
      corner_phases(whole.triangles, pattern.waves, pattern.solution.z, pattern.phase_shift);
  pattern.quality = measure_quality(whole, pattern.waves, pattern.corners);
  return pattern;
}

/// Every vertex has one phase, wave, frequency and branch flag on all ranks, and metrics are those
/// of the whole.
inline void expect_one_pattern(const Mesh& whole, vtkPolyData& output) {
  for (const char* name : {"phase", "sin_phase", "direction", "frequency", "valid", "branch"}) {
    const Gathered gathered(whole.vertex_count(), output, name);
    EXPECT_EQ(gathered.different, 0u) << name;
    EXPECT_EQ(std::ranges::count(gathered.known, 1), static_cast<long>(whole.vertex_count()));
  }
  const StripePattern pattern = whole_pattern(whole, output);
  std::vector<float> branches(whole.vertex_count());
  for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
    if (!is_branch(pattern.corners[t].kind)) continue;
    for (const Index v : whole.triangles[t]) branches[v] = 1;
  }
  const Gathered told(whole.vertex_count(), output, "branch");
  std::size_t wrong = 0;
  for (std::size_t v = 0; v < branches.size(); ++v) wrong += told.values[v][0] != branches[v];
  EXPECT_EQ(wrong, 0u) << "branches";
  if (output.GetNumberOfPoints() == 0) return;
  EXPECT_EQ(metric(output, "branches"), static_cast<double>(pattern.quality.branches));
  EXPECT_NEAR(metric(output, "angle_error_mean_deg"), pattern.quality.angle_error_mean_deg, 1e-3);
  EXPECT_NEAR(metric(output, "spacing_error_mean"), pattern.quality.spacing_error_mean, 1e-5);
}

/// Stripes of a swirl, without texture coordinates.
inline void lay_swirl(vtkBrindleStripes& filter, vtkPolyData* data, float angle = 0) {
  add_swirl(*data, angle);
  data->Modified();
  filter.SetInputData(data);
  filter.SetField(kArray);
  choose(filter, 0, "v");
  filter.SetTextureCoordinates(false);
  filter.Update();
}

/// The library's results for the partitions, frame by frame.
class Twin {
 public:
  Twin(const Pieces& pieces, std::vector<std::uint64_t> numbers, float slack = 0)
      : pieces_(pieces),
        surface_({pieces.own, std::move(numbers), {}}, MPI_COMM_WORLD),
        animator_(surface_, with_slack(slack)) {}

  std::span<const Complex> frame(float angle) {
    last_ = pattern(angle);
    return last_.solution.z;
  }

  /// The next frame, with the swirl turned about the normals.
  StripePattern pattern(float angle, float turn = 0) {
    std::vector<Vec3> vectors;
    for (const Vec3& p : pieces_.own.positions) vectors.push_back(swirl(p, angle));
    StripePattern made;
    made.waves.positions = pieces_.own.positions;
    made.waves.directions = tangent_directions(vectors, surface_.normals());
    if (turn != 0) made.waves.directions = rotated(made.waves.directions, surface_.normals(), turn);
    made.waves.frequencies.assign(
        vectors.size(), frequency_of_stripes(40, static_cast<float>(surface_.diagonal())));
    const FrameResult frame =
        animator_.frame({made.waves.positions, made.waves.directions, made.waves.frequencies});
    made.solution.z.assign(frame.z.begin(), frame.z.end());
    if (frame.frequencies.empty()) return made;
    made.frequencies_wanted = made.waves.frequencies;
    made.waves.frequencies.assign(frame.frequencies.begin(), frame.frequencies.end());
    return made;
  }

  DistributedMeasures measure() const { return animator_.measure(); }

 private:
  static DistributedOptions with_slack(float slack) {
    DistributedOptions options;
    options.slack = slack;
    return options;
  }

  const Pieces& pieces_;
  DistributedSurface surface_;
  DistributedStripeAnimator animator_;
  StripePattern last_;
};

inline std::vector<std::uint64_t> numbers_by_place(const Pieces& pieces) {
  return global_numbers(ranks(), {pieces.own.positions, {}}, 1).of_points;
}

}  // namespace brindle::paraview
