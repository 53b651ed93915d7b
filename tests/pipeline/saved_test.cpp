#include "brindle/saved.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/threads.h"
#include "progress_reports.h"
#include "test_folder.h"

namespace brindle {
namespace {

constexpr int kFrames = 5;

struct SavedFiles : TestFolder {
  std::filesystem::path file = folder / "saved.brindle";

  std::string content() const {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void set_content(const std::string& bytes) const {
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::ssize(bytes));
  }
};

template <class T>
std::string bits(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
template <class T>
std::string bits(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
std::string bits(double number) { return std::to_string(std::bit_cast<std::uint64_t>(number)); }

Surface creased_surface(const char* shape) {
  Mesh mesh = make_shape(shape);
  Creases creases = split_at_creases(mesh);
  return make_surface(std::move(mesh), std::move(creases));
}

/// A field that turns, on a surface that moves and of which some directions are reversed.
struct MovingWaves {
  Surface surface;
  WaveSet waves;

  explicit MovingWaves(Surface made, int symmetry = 2) : surface(std::move(made)) {
    const float f = frequency_of_stripes(14, bounding_box(surface.mesh).diagonal());
    waves = {surface.mesh.positions, smooth_direction_field(surface, {.symmetry = symmetry}),
             constant_frequency_field(f, surface.mesh.vertex_count())};
  }
  WaveSet at(int frame) const {
    WaveSet now = waves;
    const auto t = static_cast<float>(frame);
    now.directions = rotated(waves.directions, surface.normals, 0.15f * t);
    for (std::size_t i = 0; i < now.positions.size(); ++i) {
      now.positions[i] *= 1 + 0.02f * t;
      now.frequencies[i] *= 1 + 0.1f * std::sin(t + now.positions[i].x());
      if ((i * 7 + static_cast<std::size_t>(frame)) % 5 == 0) now.directions[i] *= -1;
    }
    return now;
  }
};

FrameInput frame_input(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

std::string bits_of_frame(const FrameResult& frame) {
  return bits(frame.z) + bits(frame.frequencies) + bits(frame.phase_step) +
         bits(frame.frequency_change.ratio_mean) + (frame.unchanged ? "1" : "0");
}

/// Runs an animator without interruption and saves it before every frame. All that are loaded must
/// give the same bits in every frame from there on, on any number of threads.
template <class Animator, class Load, class Frame>
void expect_the_same_bits(const std::filesystem::path& file, const Surface& surface,
                          Animator animator, const Load& load, const Frame& frame,
                          const std::string& name) {
  std::vector<Animator> loaded;
  for (int n = 0; n < kFrames; ++n) {
    save(file, surface, animator);
    loaded.push_back(load(file).result);
    const std::string expected = frame(animator, n);
    const ThreadLimit limit(1 + n % 3);
    for (std::size_t k = 0; k < loaded.size(); ++k) {
      EXPECT_TRUE(frame(loaded[k], n) == expected)
          << name << ": saved before frame " << k << ", differs in frame " << n;
    }
  }
}

/// The number of a frame's input: the last frame but one is repeated.
int input_number(int frame) { return frame + 1 == kFrames ? frame - 1 : frame; }

struct StripeCase {
  std::string name;
  AnimatorOptions options = {};
  Surface surface = make_surface(make_shape("torus,resolution=24"));
  /// Called before a frame.
  std::function<void(StripeAnimator&, int, const WaveSet&)> change = [](auto&, int, auto&) {};
};

std::vector<StripeCase> stripe_cases() {
  std::vector<StripeCase> cases;
  const auto add = [&](const char* name) -> StripeCase& {
    cases.push_back({});
    cases.back().name = name;
    return cases.back();
  };
  add("multilevel");
  add("from scratch").options.lambda = 0;
  add("cycles").options.cycles = 2;
  add("trapezoid").options.phase_shift = PhaseShiftKind::trapezoid;
  add("relaxation").options.solver = FrameSolver::relaxation;
  add("slack").options.slack = 0.3f;
  StripeCase& weighted = add("edge weights");
  weighted.options.edge_weights.assign(weighted.surface.neighborhood->neighbors.size(), 0.5f);
  StripeCase& avoiding = add("branch avoidance");
  avoiding.options.slack = 0.3f;
  avoiding.options.slack.branch_penalty.assign(avoiding.surface.mesh.vertex_count(), 0);
  avoiding.options.slack.branch_penalty[7] = 1;
  avoiding.options.solver = FrameSolver::relaxation;
  StripeCase& changing = add("changing slack");
  changing.options.slack = 0.2f;
  changing.change = [](StripeAnimator& animator, int frame, const WaveSet& waves) {
    Slack slack = 0.4f;
    if (frame == 3) slack.branch_penalty.assign(waves.positions.size(), 0.5f);
    if (frame == 1 || frame == 3) animator.set_slack(slack);
    if (frame == 4) animator.set_slack(0);
  };
  add("restarted").change = [](StripeAnimator& animator, int frame, const WaveSet&) {
    if (frame == 2) animator.restart();
  };
  add("given phases").change = [](StripeAnimator& animator, int frame, const WaveSet& waves) {
    std::vector<Complex> z(waves.positions.size(), Complex(1));
    z[5] = 0;
    if (frame % 2 == 0) animator.set_last_phases(z);
  };
  add("creases").surface = creased_surface("box,resolution=12");
  StripeCase& mobius = add("unorientable");
  mobius.surface = make_surface(make_shape("mobius,resolution=30"));
  mobius.options.slack = 0.3f;
  return cases;
}

TEST_F(SavedFiles, StripeAnimatorsGoOnWithTheSameBits) {
  for (const StripeCase& c : stripe_cases()) {
    const MovingWaves moving(c.surface);
    const auto frame = [&](StripeAnimator& animator, int n) {
      const WaveSet waves = moving.at(input_number(n));
      c.change(animator, n, waves);
      const std::string result = bits_of_frame(animator.frame(frame_input(waves)));
      return result + bits(animator.energy());
    };
    expect_the_same_bits(file, c.surface, StripeAnimator(c.surface, c.options),
                         load_stripe_animator, frame, c.name);
    expect_the_same_bits(file, c.surface, StripeAnimator(c.surface, c.options).sibling(),
                         load_stripe_animator, frame, c.name + ", sibling");
  }
}

TEST_F(SavedFiles, AnimatorsOfNeighboursGoOn) {
  const MovingWaves moving(make_surface(make_shape("sphere,resolution=12")));
  const auto frame = [&](StripeAnimator& animator, int n) {
    WaveSet waves = moving.at(n);
    // The first frames have no waves, so that levels are built later.
    if (n < 2) std::fill(waves.directions.begin(), waves.directions.end(), Vec3::Zero());
    return bits_of_frame(animator.frame(frame_input(waves)));
  };
  expect_the_same_bits(file, moving.surface, StripeAnimator(moving.surface.neighborhood),
                       load_stripe_animator, frame, "neighbours");
}

TEST_F(SavedFiles, AnimatorsOfPointsGoOn) {
  if (!has_point_trees()) GTEST_SKIP() << "this build has no nanoflann";
  const Mesh torus = make_shape("torus,resolution=24");
  const MovingWaves moving(make_point_surface(make_point_cloud(torus.positions).cloud));
  AnimatorOptions options;
  options.slack = 0.2f;
  const auto frame = [&](StripeAnimator& animator, int n) {
    return bits_of_frame(animator.frame(frame_input(moving.at(n))));
  };
  expect_the_same_bits(file, moving.surface, StripeAnimator(moving.surface, options),
                       load_stripe_animator, frame, "points");
}

TEST(SavedBytes, AreThoseBeforeACancelledFrame) {
  const MovingWaves moving(make_surface(make_shape("torus,resolution=24")));
  WaveSet none = moving.at(0);
  std::fill(none.directions.begin(), none.directions.end(), Vec3::Zero());
  AnimatorOptions slack, relaxation, cycles;
  slack.slack = 0.2f;
  relaxation.solver = FrameSolver::relaxation;
  cycles.cycles = 2;
  for (const AnimatorOptions& options : {slack, relaxation, cycles}) {
    // Levels are built in the first frame with waves, which need not be the first.
    for (const WaveSet& first : {none, moving.at(0)}) {
      for (int cancelled = 0;; ++cancelled) {
        StripeAnimator animator(moving.surface, options);
        for (const WaveSet& waves : {first, moving.at(1)}) {
          const std::string before = saved_bytes(moving.surface, animator);
          testing_support::Reports reports(cancelled);
          try {
            animator.frame(frame_input(waves), reports.progress());
          } catch (const Cancelled&) {
            EXPECT_TRUE(saved_bytes(moving.surface, animator) == before);
            animator.frame(frame_input(waves));
          }
        }
        StripeAnimator other(moving.surface, options);
        other.frame(frame_input(first));
        testing_support::Reports reports;
        other.frame(frame_input(moving.at(1)), reports.progress());
        EXPECT_TRUE(saved_bytes(moving.surface, other) == saved_bytes(moving.surface, animator));
        if (cancelled > reports.count() + 5) break;
      }
    }
  }
}

std::string bits_of_corners(const TextureWaves& waves) {
  std::string result;
  for (const auto* list : {&waves.u, &waves.v}) {
    for (const CornerWaves& corners : *list) {
      for (const CornerWave& corner : corners) {
        result.append(reinterpret_cast<const char*>(corner.wave.direction.data()), sizeof(Vec3));
        result.append(reinterpret_cast<const char*>(&corner.z), sizeof corner.z);
      }
    }
  }
  return result;
}

std::string bits_of_texture(const TextureQuality& q) {
  return bits(q.area_mean) + bits(q.angle_95th_deg);
}

TEST_F(SavedFiles, TextureAnimatorsGoOnWithTheSameBits) {
  struct Case {
    const char* shape;
    TextureAnimatorOptions options = {};
  };
  std::vector<Case> cases = {{"sphere,resolution=12"}, {"mobius,resolution=30"},
                             {"torus,resolution=24"},  {"sphere,resolution=12"},
                             {"torus,resolution=24"},  {"sphere,resolution=12"}};
  cases[2].options.oriented = true;
  cases[3].options.stripes.slack = 0.3f;
  cases[3].options.whole_tiles.emplace();
  cases[4].options.stripes.solver = FrameSolver::relaxation;
  cases[4].options.whole_tiles = TileMotifs{.layout = TileLayout::courses, .split = true};
  cases[5].options.stripes.lambda = 0;
  for (const Case& c : cases) {
    const TextureAnimatorOptions& options = c.options;
    const MovingWaves moving(make_surface(make_shape(c.shape)));
    const auto frame = [&](TextureAnimator& animator, int n) {
      if (n == 3 && options.stripes.slack.relaxes()) animator.set_slack(0.1f);
      const WaveSet waves = moving.at(input_number(n));
      const TextureFrameResult r =
          animator.frame({{waves.positions, waves.directions, waves.frequencies}, {}, {}});
      return bits_of_frame(r.u) + bits_of_frame(r.v) + bits_of_corners(r.pattern.waves) +
             bits_of_texture(r.pattern.quality) + std::to_string(static_cast<int>(r.orientation)) +
             std::to_string(r.pattern.seams.turned) + bits(animator.energy_u()) +
             bits(animator.energy_v()) + (r.broken ? bits(r.broken->words) : "");
    };
    expect_the_same_bits(file, moving.surface, TextureAnimator(moving.surface, options),
                         load_texture_animator, frame, c.shape);
  }
}

TEST_F(SavedFiles, CrossAnimatorsGoOnWithTheSameBits) {
  for (const bool slack : {false, true}) {
    for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
      const MovingWaves moving(make_surface(make_shape("sphere,resolution=12")), 4);
      AnimatorOptions options;
      options.solver = solver;
      if (slack) options.slack = 0.3f;
      const auto frame = [&](CrossAnimator& animator, int n) {
        if (slack && n == 2) animator.set_slack(0);
        WaveSet waves = moving.at(input_number(n));
        if (n == 3)
          waves.directions[40] = rotated(std::vector{waves.directions[40]},
                                         std::vector{moving.surface.normals[40]}, 0.7f)[0];
        const CrossFrameResult r =
            animator.frame({{waves.positions, waves.directions, waves.frequencies}, {}});
        return bits_of_frame(r.stripes) + bits(r.mesh.positions) + bits(r.mesh.triangles) +
               bits_of_corners(r.waves) + bits(r.quality.angle_error_mean_deg) +
               bits_of_texture(r.texture) + std::to_string(static_cast<int>(r.matching)) +
               bits(animator.energy());
      };
      expect_the_same_bits(file, moving.surface, CrossAnimator(moving.surface, options),
                           load_cross_animator, frame, slack ? "crosses, slack" : "crosses");
    }
  }
}

std::string bits_of_pattern(const StripePattern& p) {
  std::string corners;
  for (const CornerPhases& c : p.corners) {
    corners.append(reinterpret_cast<const char*>(c.phase.data()), sizeof c.phase);
    corners += static_cast<char>(c.kind);
    corners += static_cast<char>(c.branch_index);
  }
  return bits(p.waves.positions) + bits(p.waves.directions) + bits(p.waves.frequencies) +
         bits(p.frequencies_wanted) + bits(p.solution.z) + bits(p.solution.energy) +
         bits(p.solution.energy_per_iteration) + corners + bits(p.quality.angle_error_mean_deg) +
         std::to_string(p.quality.branches) + std::to_string(p.quality.vertices_without_wave) +
         std::to_string(p.quality.branches_in_avoided_area.value_or(77)) +
         (p.frequency_change ? bits(p.frequency_change->ratio_max) : "");
}

TEST_F(SavedFiles, PatternsComeBackWithEveryBit) {
  for (const Solver solver :
       {Solver::multilevel, Solver::relaxation, Solver::averaged, Solver::global}) {
    if (!is_available(solver)) continue;
    for (const float slack : {0.0f, 0.3f}) {
      Mesh moved = make_shape("bracket");
      moved.origin = {5e6, 1, 2};
      Creases creases = split_at_creases(moved);
      const Surface surface = make_surface(std::move(moved), std::move(creases));
      ASSERT_FALSE(surface.creases.empty());
      StripeOptions options;
      options.solver.solver = solver;
      options.slack = slack;
      if (slack > 0) options.slack.branch_penalty.assign(surface.mesh.vertex_count(), 0.6f);
      DirectionField field = smooth_direction_field(surface);
      field[3] = Vec3::Zero();
      const float f = frequency_of_stripes(20, bounding_box(surface.mesh).diagonal());
      const StripePattern pattern = stripe_pattern(surface, field, f, options);
      save(file, surface, pattern);
      const auto [again, result] = load_pattern(file);
      EXPECT_TRUE(bits_of_pattern(result) == bits_of_pattern(pattern));
      EXPECT_EQ(again.mesh.origin, surface.mesh.origin);
      EXPECT_EQ(again.turned, surface.turned);
      EXPECT_EQ(bits(stripe_curves(again, result).lines.points),
                bits(stripe_curves(surface, pattern).lines.points));
    }
  }
}

// ---- Damaged files ------------------------------------------------------------------------------

std::string error_of(const std::function<void()>& load) {
  try {
    load();
  } catch (const Error& error) {
    return error.what();
  }
  return "loaded";
}

TEST_F(SavedFiles, ErrorsNameFileAndRemedy) {
  const MovingWaves moving(make_surface(make_shape("torus,resolution=8")));
  save(file, moving.surface, StripeAnimator(moving.surface));
  const std::string good = content();
  const auto expect_error = [&](const std::string& bytes, const char* message) {
    set_content(bytes);
    const std::string error = error_of([&] { load_stripe_animator(file); });
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_EQ(error.find(file.string()), 0u) << error;
  };
  EXPECT_EQ(error_of([&] { load_stripe_animator(file); }), "loaded");
  EXPECT_NE(error_of([&] { load_pattern(file); }).find("holds a StripeAnimator, not a pattern"),
            std::string::npos);
  std::string newer = good, foreign = good, flipped = good;
  newer[8] = 9;
  foreign[0] = 'x';
  flipped[good.size() / 2] ^= 1;
  expect_error(newer, "newer brindle (format 9)");
  expect_error(foreign, "not a file that brindle saved");
  expect_error(flipped, "damaged");
  expect_error(good + "x", "damaged");
  for (std::size_t size = 8; size < good.size(); size += 97) {
    expect_error(good.substr(0, size), "truncated");
  }
  expect_error("brin", "not a file that brindle saved");
  EXPECT_THROW(load_pattern(folder / "missing"), Error);
  EXPECT_THROW(load_pattern(folder), Error);
  const Surface other = make_surface(make_shape("torus,resolution=9"));
  EXPECT_THROW(save(file, other, StripeAnimator(moving.surface)), Error);
  const StripePattern pattern = stripe_pattern(moving.surface, moving.at(0));
  EXPECT_NE(error_of([&] { save(file, other, pattern); }).find("of another surface"),
            std::string::npos);
  EXPECT_THROW(save(folder / "no" / "folder", moving.surface, StripeAnimator(moving.surface)),
               Error);
}

/// The checksum in the header, as in saved.cpp.
void repair_checksum(std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3u;
    hash ^= hash >> 32;
  };
  std::size_t at = 32;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + at, 8);
    add(word);
  }
  for (; at < bytes.size(); ++at) add(static_cast<unsigned char>(bytes[at]));
  const std::uint64_t size = bytes.size() - 32;
  std::memcpy(bytes.data() + 16, &size, 8);
  std::memcpy(bytes.data() + 24, &hash, 8);
}

/// Mutates the payload of a good file, whose checksum fits nevertheless. Numbers of sweeps are
/// spared, since frames would take forever.
std::string mutated(std::string bytes, float lambda, std::mt19937& random) {
  std::size_t spared = bytes.find(std::string(reinterpret_cast<const char*>(&lambda), 4), 32);
  if (spared == std::string::npos) spared = bytes.size();
  const int count = 1 + static_cast<int>(random() % 4);
  for (int m = 0; m < count; ++m) {
    const std::size_t at = 32 + random() % (bytes.size() - 32);
    if (at >= spared && at < spared + 16) continue;
    if (random() % 2 == 0) {
      bytes[at] = static_cast<char>(random());
    } else {
      constexpr std::uint32_t kWords[] = {0,          1,          0xffffffff, 0x7fc00000,
                                          0x7f800000, 0x80000000, 1000};
      const std::size_t word = at / 4 * 4;
      if (word + 4 > bytes.size() || (word + 4 > spared && word < spared + 16)) continue;
      std::memcpy(bytes.data() + word, &kWords[random() % 7], 4);
    }
  }
  if (random() % 8 == 0) bytes.resize(32 + random() % (bytes.size() - 32));
  repair_checksum(bytes);
  return bytes;
}

TEST_F(SavedFiles, MutatedFilesAreLoadedSafelyOrRejected) {
  constexpr int kTries = 400;
  constexpr float kLambda = 0.0312f;
  const MovingWaves moving(creased_surface("torus,resolution=8"));
  const MovingWaves crossing(make_surface(make_shape("torus,resolution=8")), 4);
  AnimatorOptions options;
  options.lambda = kLambda;
  options.slack = 0.2f;
  const WaveSet waves = moving.at(0), next = moving.at(1), crosses = crossing.at(0);
  StripeAnimator stripes(moving.surface, options);
  stripes.frame(frame_input(waves));
  TextureAnimator texture(moving.surface, {false, options, TileMotifs()});
  texture.frame({frame_input(waves), {}, {}});
  CrossAnimator cross(crossing.surface, options);
  cross.frame({frame_input(crosses), {}});
  const StripePattern pattern = stripe_pattern(moving.surface, waves);
  std::mt19937 random(1);
  int loaded = 0;
  const auto try_all = [&](const auto& load) {
    const std::string good = content();
    for (int n = 0; n < kTries; ++n) {
      set_content(mutated(good, kLambda, random));
      loaded += error_of(load) == "loaded";
    }
  };
  save(file, moving.surface, pattern);
  try_all([&] {
    const auto [surface, result] = load_pattern(file);
    stripe_curves(surface, result);
  });
  save(file, moving.surface, stripes);
  try_all([&] { load_stripe_animator(file).result.frame(frame_input(next)); });
  save(file, moving.surface, texture);
  try_all([&] { load_texture_animator(file).result.frame({frame_input(next), {}, {}}); });
  save(file, crossing.surface, cross);
  try_all([&] { load_cross_animator(file).result.frame({frame_input(crosses), {}}); });
  EXPECT_GT(loaded, kTries / 10);  // not all damage is beyond what a file may hold
  EXPECT_LT(loaded, 4 * kTries);
}

}  // namespace
}  // namespace brindle
