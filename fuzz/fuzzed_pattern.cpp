#include "fuzzed_pattern.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/error.h"
#include "brindle/mesh.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "bytes.h"
#include "promises.h"

namespace brindle::fuzz {
namespace {

/// A strip of a grid whose vertices move, and triangles by chance.
Mesh fuzzed_mesh(Bytes& bytes) {
  const std::size_t columns = 2 + bytes.below(5), rows = 2 + bytes.below(4);
  std::vector<float> positions;
  std::vector<std::int32_t> triangles;
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const Vec3 moved = Vec3(static_cast<float>(i % columns), static_cast<float>(i / columns), 0) +
                       0.05f * bytes.vector();
    positions.insert(positions.end(), {moved.x(), moved.y(), moved.z()});
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t v : {a, b, c}) triangles.push_back(static_cast<std::int32_t>(v));
  };
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const std::size_t a = row * columns + column;
      add(a, a + 1, a + columns);
      add(a + 1, a + columns + 1, a + columns);
    }
  }
  for (std::size_t more = bytes.below(6); more > 0; --more) {
    // One beyond the last vertex, too.
    const std::size_t count = columns * rows + 1;
    const std::size_t a = bytes.below(count), b = bytes.below(count);
    add(a, b, bytes.below(count));
  }
  return make_repaired_mesh(ArrayView(positions, 3), ArrayView(triangles, 3)).mesh;
}

/// Tangent mostly, or else to be refused.
Vec3 fuzzed_direction(Bytes& bytes, const Vec3& normal) {
  const Vec3 any = bytes.vector();
  if (bytes.below(16) == 0) return any;
  return (any - any.dot(normal) * normal).stableNormalized();
}

StripeOptions fuzzed_options(Bytes& bytes) {
  StripeOptions options;
  options.phase_shift = static_cast<PhaseShiftKind>(bytes.below(3));
  options.weights = bytes.flag() ? EdgeWeights::cotangent : EdgeWeights::paper;
  options.solver.solver = static_cast<Solver>(bytes.below(3));
  options.solver.cycles = static_cast<int>(bytes.below(4));
  if (bytes.flag()) options.slack = bytes.number() / 8;
  return options;
}

void check_phases(std::span<const Complex> z) {
  for (const Complex& value : z) {
    promise(std::isfinite(value.real()) && std::isfinite(value.imag()), "phases are numbers");
    const float size = std::abs(value);
    promise(size == 0 || std::abs(size - 1) < 1e-4f, "phases are unit numbers, or 0");
  }
}

void check_energy(double energy) {
  promise(energy >= 0 && energy <= 1, "an energy is between 0 and 1");
}

void check_curves(const StripeCurves& curves) {
  promise(curves.lines.points.size() == curves.lines.normals.size(), "points have normals");
  for (const Vec3& point : curves.lines.points) promise(point.allFinite(), "points are finite");
}

bool same(std::span<const Complex> a, std::span<const Complex> b) {
  return std::ranges::equal(a, b);
}

/// Cancels a frame at one of its reports, if there are so many, and makes it then.
FrameResult cancelled_and_done(StripeAnimator& animator, const FrameInput& input,
                               std::size_t report) {
  std::size_t reports = 0;
  const Progress progress([&](std::string_view, double) { return reports++ != report; });
  try {
    return animator.frame(input, progress);
  } catch (const Cancelled&) {
    return animator.frame(input);
  }
}

void run_frames(Bytes& bytes, const Surface& surface, DirectionField directions,
                FrequencyField frequencies) {
  AnimatorOptions options;
  options.lambda = std::abs(bytes.number()) / 64;
  StripeAnimator animator(surface, options), twin(surface, options);
  for (std::size_t frames = bytes.below(4); frames > 0; --frames) {
    const std::size_t v = bytes.below(directions.size());
    directions[v] = fuzzed_direction(bytes, surface.normals[v]);
    const FrameInput input{surface.mesh.positions, directions, frequencies};
    const std::size_t report = bytes.flag() ? bytes.below(8) : 1000;
    const FrameResult result = cancelled_and_done(animator, input, report);
    check_phases(result.z);
    check_energy(animator.energy());
    promise(same(result.z, twin.frame(input).z), "a cancelled frame leaves no trace");
  }
}

}  // namespace

void run_pattern(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const Surface surface = make_surface(fuzzed_mesh(bytes));
  DirectionField directions = smooth_direction_field(surface);
  FrequencyField frequencies(surface.mesh.vertex_count(), std::abs(bytes.number()));
  for (std::size_t changed = bytes.below(8); changed > 0; --changed) {
    const std::size_t v = bytes.below(directions.size());
    directions[v] = fuzzed_direction(bytes, surface.normals[v]);
    frequencies[bytes.below(frequencies.size())] = bytes.number();
  }
  const StripeOptions options = fuzzed_options(bytes);
  const StripePattern pattern = stripe_pattern(surface, directions, frequencies, options);
  check_phases(pattern.solution.z);
  check_energy(pattern.solution.energy);
  const StripePattern again = stripe_pattern(surface, directions, frequencies, options);
  promise(same(pattern.solution.z, again.solution.z), "the same request has the same bits");
  check_curves(stripe_curves(surface, pattern));
  check_curves(stripe_curves(surface, pattern, {.join = true, .fair = 0.25f}));
  run_frames(bytes, surface, directions, frequencies);
}

}  // namespace brindle::fuzz
