// What seeing a measured field at the scale of its stripes costs, in frames of the stripes
// themselves: from scratch with all that depends on the surface, and in a frame that goes on from
// the last one. Both sides take turns, and medians are compared.
// `measured_field_cost [shape] [stripes]`.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/stopwatch.h"
#include "brindle/frequency_field.h"
#include "brindle/measured_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"

namespace {

using namespace brindle;

constexpr int kRounds = 41;

double milliseconds(const std::function<void()>& work) {
  Stopwatch watch;
  work();
  return watch.lap();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// The field turned by an angle, and by noise of 20 degrees on average.
MeasuredField noisy(const Surface& surface, const DirectionField& field, int seed, float turn) {
  MeasuredField measured{field, {}};
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double sine = std::sin(static_cast<double>(i) * 12.9898 + seed * 78.233) * 43758.5453;
    const float angle = turn + 0.7f * static_cast<float>(2 * (sine - std::floor(sine)) - 1);
    measured.directions[i] =
        std::cos(angle) * field[i] + std::sin(angle) * surface.normals[i].cross(field[i]);
  }
  return measured;
}

void measure(const std::string& shape, float stripes) {
  const Surface surface = make_surface(make_shape(shape));
  const DirectionField field = smooth_direction_field(surface);
  const FrequencyField frequencies = constant_frequency_field(
      frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal()), field.size());
  StripeAnimator animator(surface);
  FieldSmoothing going_on(surface), of_new_noise(surface);
  std::vector<double> frame, scratch, moved, renewed;
  for (int round = 0; round < kRounds; ++round) {
    const float turn = 0.01f * static_cast<float>(round);
    const DirectionField turned = rotated(field, surface.normals, turn);
    const MeasuredField same = noisy(surface, field, 0, turn);
    const MeasuredField other = noisy(surface, field, round, turn);
    frame.push_back(milliseconds([&] {
      animator.frame({surface.mesh.positions, turned, frequencies});
    }));
    scratch.push_back(milliseconds([&] { FieldSmoothing(surface).frame(same, frequencies); }));
    moved.push_back(milliseconds([&] { going_on.frame(same, frequencies); }));
    renewed.push_back(milliseconds([&] { of_new_noise.frame(other, frequencies); }));
  }
  const double unit = median(frame);
  std::printf(
      "%zu vertices, a frame %.2f ms; a measured field from scratch %.1f frames, that goes on and "
      "turns %.1f, with new noise %.1f\n",
      field.size(), unit, median(scratch) / unit, median(moved) / unit, median(renewed) / unit);
}

}  // namespace

int main(int count, char** words) {
  try {
    measure(count > 1 ? words[1] : "torus", count > 2 ? std::strtof(words[2], nullptr) : 40);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
