#include "brindle/pattern_frames.h"

#include <cmath>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "phase_graphs.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;

template <class Entry>
bool same_bits(std::span<const Entry> a, const std::vector<Entry>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

bool same_corners(std::span<const CornerPhases> a, const std::vector<CornerPhases>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t t = 0; t < a.size(); ++t) {
    const bool same = std::memcmp(&a[t].phase, &b[t].phase, sizeof a[t].phase) == 0 &&
                      a[t].sign == b[t].sign && a[t].branch_index == b[t].branch_index &&
                      a[t].kind == b[t].kind;
    if (!same) return false;
  }
  return true;
}

/// A surface through which a wave runs, with directions that stay tangent to it.
struct MovingSurface {
  explicit MovingSurface(const std::string& shape)
      : rest(make_surface(make_shape(shape))), now(rest.mesh) {
    go_on(0);
  }

  void go_on(int step) {
    for (std::size_t v = 0; v < now.positions.size(); ++v) {
      const Vec3& p = rest.mesh.positions[v];
      now.positions[v] = p * (1 + 0.05f * std::sin(4 * p.x() + 0.3f * static_cast<float>(step)));
    }
    normals = vertex_normals(now);
    waves = {now.positions, projected_direction_field(kAxis, normals),
             FrequencyField(now.positions.size(), 14 / bounding_box(rest.mesh).diagonal())};
    flip_half(waves, static_cast<std::uint32_t>(step));
  }

  FrameInput input() const { return {waves.positions, waves.directions, waves.frequencies}; }

  Surface rest;
  Mesh now;
  std::vector<Vec3> normals;
  WaveSet waves;
};

TEST(PatternFrames, TurnTheTrianglesThatTheSurfaceTurns) {
  const MovingSurface torus("torus,resolution=40");
  PatternFrames frames(make_surface(with_turned_triangles(torus.rest.mesh)));
  const std::span<const Vec3> found = frames.normals(torus.now.positions);
  for (std::size_t v = 0; v < found.size(); ++v) {
    ASSERT_LT((found[v] - torus.normals[v]).norm(), 1e-6f) << v;
  }
}

// What is renewed in place is what is made afresh, bit for bit, whether vertices moved or not, with
// frequencies that yield and without.
TEST(PatternFrames, AreThoseOfAFreshPatternBitForBit) {
  for (const float slack : {0.0f, 0.3f}) {
    MovingSurface surface("torus,resolution=40");
    AnimatorOptions options;
    options.slack = slack;
    StripeAnimator animator(surface.rest, options);
    PatternFrames frames(surface.rest);
    std::vector<PatternVertex> vertices(surface.now.vertex_count());
    std::size_t chosen = 0;
    for (const int step : {0, 1, 2, 2, 3, 0}) {
      surface.go_on(step);
      const FrameResult frame = animator.frame(surface.input());
      frames.fill(surface.input(), frame, vertices);
      EXPECT_TRUE(same_bits(frames.normals(surface.now.positions), surface.normals)) << step;
      WaveSet waves = surface.waves;
      chosen += frame.frequencies.size();
      if (slack > 0) waves.frequencies.assign(frame.frequencies.begin(), frame.frequencies.end());
      const PatternBuffers fresh = pattern_buffers(
          {waves.positions, surface.normals, waves.directions, waves.frequencies, frame.z},
          surface.now.triangles);
      EXPECT_TRUE(same_bits<PatternVertex>(vertices, fresh.vertices)) << slack << ' ' << step;
      for (const PhaseShiftKind kind : {PhaseShiftKind::aligned, PhaseShiftKind::common_source}) {
        EXPECT_TRUE(same_corners(frames.corners(surface.input(), frame, kind),
                                 corner_phases(surface.now.triangles, waves, frame.z, kind)))
            << slack << ' ' << step;
      }
    }
    EXPECT_EQ(chosen > 0, slack > 0);
  }
}

TEST(PatternFrames, DrawByTheNormalsThatAFrameHas) {
  const MovingSurface surface("sphere,resolution=10");
  StripeAnimator animator(surface.rest);
  FrameInput input = surface.input();
  std::vector<Vec3> radial;
  for (const Vec3& p : surface.rest.mesh.positions) radial.push_back(p.normalized());
  input.positions = surface.rest.mesh.positions;
  const DirectionField field = projected_direction_field(kAxis, radial);
  input.directions = field;
  input.normals = radial;
  const FrameResult frame = animator.frame(input);
  std::vector<PatternVertex> vertices(radial.size());
  PatternFrames(surface.rest).fill(input, frame, vertices);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(vertices[v].normal[axis], radial[v][axis]);
  }
}

std::string refusal(auto&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PatternFrames, RefuseWhatDoesNotFitAndGoOn) {
  MovingSurface surface("torus,resolution=12");
  StripeAnimator animator(surface.rest);
  PatternFrames frames(surface.rest);
  const FrameResult frame = animator.frame(surface.input());
  std::vector<PatternVertex> vertices(surface.now.vertex_count() - 1);
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(refusal([&] { frames.fill(surface.input(), frame, vertices); }), "entries for"));
  const std::span<const Vec3> few(surface.now.positions.data(), 3);
  EXPECT_TRUE(has(refusal([&] { frames.normals(few); }), "3 positions for"));
  FrameResult none = frame;
  none.z = {};
  EXPECT_TRUE(has(refusal([&] { frames.corners(surface.input(), none); }), "0 phases for"));
  FrameInput input = surface.input();
  input.directions = input.directions.first(2);
  EXPECT_TRUE(has(refusal([&] { frames.corners(input, frame); }), "one position, direction"));
  EXPECT_TRUE(same_bits(frames.normals(surface.now.positions), surface.normals));

  Surface points = surface.rest;
  points.mesh.triangles.clear();
  EXPECT_TRUE(has(refusal([&] { PatternFrames(std::as_const(points)); }), "no triangles"));
  std::vector<CornerPhases> one(1);
  EXPECT_TRUE(has(refusal([&] {
                    fill_corner_phases(surface.now.triangles, surface.waves, frame.z,
                                       PhaseShiftKind::aligned, one);
                  }),
                  "1 entries for"));
}

}  // namespace
}  // namespace brindle
