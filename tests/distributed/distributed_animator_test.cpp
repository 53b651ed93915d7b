#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "brindle/carried_phases.h"
#include "brindle/distributed_stripes.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/stripe_pattern.h"
#include "brindle/threads.h"
#include "ranks.h"
#include "torn_mesh.h"

namespace brindle {
namespace {

using namespace testing_support;

/// Directions of another frame: turned about the normals.
WaveSet turned(const WavySurface& whole, float radians) {
  WaveSet waves = whole.waves;
  waves.directions = rotated(waves.directions, whole.normals, radians);
  return waves;
}

/// Expects that what ranks say of their pattern is what the library says of the same phases.
void expect_true_metrics(const Parts& parts, const DistributedSurface& surface,
                         const DistributedStripeAnimator& animator, std::span<const Complex> z,
                         const WaveSet& waves) {
  const std::vector<Complex> all = parts.gathered(z, surface.is_own());
  const double measured = energy(build_phase_graph(parts.whole.neighborhood, waves), all);
  EXPECT_NEAR(animator.energy(), measured, 1e-5 * measured + 1e-9);
  const auto corners =
      corner_phases(parts.whole.mesh.triangles, waves, all, PhaseShiftKind::aligned);
  const PatternQuality expected = measure_quality(parts.whole.mesh, waves, corners);
  const DistributedMeasures measures = animator.measure();
  EXPECT_EQ(measures.quality.branches, expected.branches);
  EXPECT_EQ(measures.quality.field_singularities, expected.field_singularities);
  EXPECT_EQ(measures.quality.vertices_without_wave, expected.vertices_without_wave);
  EXPECT_NEAR(measures.quality.angle_error_mean_deg, expected.angle_error_mean_deg, 1e-5);
  EXPECT_NEAR(measures.quality.spacing_error_mean, expected.spacing_error_mean, 1e-6);
  EXPECT_EQ(measures.corners.size(), parts.piece.mesh.triangle_count());
  // All ranks that have a vertex have its owner's phase.
  for (std::size_t v = 0; v < parts.ids.size(); ++v) ASSERT_EQ(z[v], all[parts.ids[v]]);
}

TEST(DistributedAnimator, OfOneRankHasTheBitsOfTheLibrary) {
  if (rank_count() > 1) GTEST_SKIP() << "of one rank";
  for (const int cycles : {0, 2}) {
    for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
      const Parts parts(wavy_surface("molecule", kAxis, 40));
      DistributedOptions options;
      options.cycles = cycles;
      options.solver = solver;
      StripeAnimator expected(parts.whole.neighborhood, options);
      DistributedStripeAnimator animator(parts.surface(), options);
      for (const float angle : {0.0f, 0.1f, 0.2f, 3.0f}) {
        const WaveSet waves = turned(parts.whole, angle);
        const FrameResult one = expected.frame(frame_of(waves));
        const FrameResult same = animator.frame(frame_of(waves));
        EXPECT_TRUE(same_bits(one.z, same.z));
        EXPECT_EQ(one.phase_step, same.phase_step);
        EXPECT_EQ(expected.energy(), animator.energy());
      }
    }
  }
}

TEST(DistributedAnimator, OfOneRankMeasuresWhatThePatternSays) {
  if (rank_count() > 1) GTEST_SKIP() << "of one rank";
  const Parts parts(wavy_surface("vessels", kAxis, 40));
  DistributedStripeAnimator animator(parts.surface());
  const FrameResult frame = animator.frame(frame_of(parts.whole.waves));
  const StripePattern pattern = stripe_pattern(make_surface(parts.whole.mesh), parts.whole.waves);
  EXPECT_TRUE(same_bits(frame.z, std::span<const Complex>(pattern.solution.z)));
  EXPECT_EQ(animator.energy(), pattern.solution.energy);
  const DistributedMeasures measures = animator.measure();
  EXPECT_EQ(measures.quality.branches, pattern.quality.branches);
  EXPECT_EQ(measures.quality.angle_error_mean_deg, pattern.quality.angle_error_mean_deg);
  EXPECT_EQ(measures.quality.spacing_error_wanted_mean, pattern.quality.spacing_error_wanted_mean);
  ASSERT_EQ(measures.corners.size(), pattern.corners.size());
  for (std::size_t t = 0; t < pattern.corners.size(); ++t) {
    ASSERT_EQ(measures.corners[t].phase, pattern.corners[t].phase);
  }
}

/// As large surfaces have it: all ranks solve together.
DistributedOptions unplanned() {
  DistributedOptions options;
  options.plan_below = 0;
  options.gather_below = 300;
  return options;
}

/// On rank 0, which alone makes it: the animator of one process.
std::optional<StripeAnimator> animator_of_one(const Mesh& mesh, const DistributedOptions& options) {
  std::optional<StripeAnimator> one;
  if (rank() == 0) one.emplace(make_surface(mesh), options);
  return one;
}

/// A frame of rank 0's animator, which is alone.
void expect_frame_of_one(std::optional<StripeAnimator>& one, const WaveSet& waves,
                         std::span<const Complex> z, const FrameResult& frame, double energy) {
  if (!one) return;
  const FrameResult expected = one->frame(frame_of(waves));
  EXPECT_TRUE(std::ranges::equal(z, expected.z));
  EXPECT_EQ(frame.phase_step, expected.phase_step);
  EXPECT_EQ(frame.unchanged, expected.unchanged);
  EXPECT_EQ(frame.frequency_change.residual, expected.frequency_change.residual);
  EXPECT_EQ(energy, one->energy());
}

/// Expects the numbers of one process, frame by frame.
void expect_phases_of_one(const Parts& parts, const DistributedOptions& options) {
  const DistributedSurface surface = parts.surface();
  DistributedStripeAnimator many(surface, options);
  std::optional<StripeAnimator> one = animator_of_one(parts.whole.mesh, options);
  for (const float angle : {0.0f, 0.05f, 0.05f, 2.0f}) {
    const WaveSet waves = turned(parts.whole, angle), own = parts.of_piece(waves);
    const FrameResult frame = many.frame(frame_of(own));
    const std::vector<Complex> z = parts.gathered(frame.z, surface.is_own());
    EXPECT_EQ(parts.of_piece(z), std::vector<Complex>(frame.z.begin(), frame.z.end()));
    expect_frame_of_one(one, waves, z, frame, many.energy());
    if (options.slack.relaxes()) continue;
    const std::size_t branches = many.measure().quality.branches;
    if (rank() != 0) continue;
    const auto corners =
        corner_phases(parts.whole.mesh.triangles, waves, z, PhaseShiftKind::aligned);
    EXPECT_EQ(branches, measure_quality(parts.whole.mesh, waves, corners).branches);
  }
}

TEST(DistributedAnimator, OfASmallSurfaceHasThePhasesOfOneProcessHoweverItIsCut) {
  DistributedOptions relaxing, cycling, relaxed;
  relaxing.solver = FrameSolver::relaxation;
  cycling.cycles = 2;
  relaxed.slack = 0.3f;
  const WavySurface trefoil = wavy_surface("trefoil,resolution=32", kAxis, 20),
                    torn = wavy_surface(torn_mesh(), kAxis, 15);
  for (const Cut& cut : cuts()) {
    for (const WavySurface* whole : {&trefoil, &torn}) {
      SCOPED_TRACE(cut.name);
      const Parts parts(*whole, cut.rank_of_triangle(whole->mesh));
      for (const DistributedOptions& options : {DistributedOptions(), relaxing, cycling, relaxed}) {
        expect_phases_of_one(parts, options);
      }
    }
  }
}

/// Rank 0 solves surfaces with creases of any size, in moved frames, too.
TEST(DistributedAnimator, HasThePhasesOfOneProcessOverCreases) {
  Parts parts(wavy_surface("bracket", kAxis, 20));
  ASSERT_TRUE(split_at_creases(parts.surface(), parts.piece));
  const DistributedSurface surface = parts.surface();
  Mesh split = parts.whole.mesh;
  Creases creases = split_at_creases(split);
  const Surface whole = make_surface(std::move(split), std::move(creases));
  WaveSet waves{whole.mesh.positions, projected_direction_field({1, 2, 3}, whole.normals),
                FrequencyField(whole.mesh.vertex_count(), 8)};
  parts.ids = parts.piece.vertex_ids;
  parts.whole.mesh = whole.mesh;
  DistributedStripeAnimator many(surface, unplanned());
  std::optional<StripeAnimator> one;
  if (rank() == 0) one.emplace(whole, unplanned());
  for (const float bend : {0.0f, 0.1f, 0.2f}) {
    for (std::size_t v = 0; v < waves.positions.size(); ++v) {
      waves.positions[v].z() += bend * waves.positions[v].x() * waves.positions[v].x();
    }
    const WaveSet own = parts.of_piece(waves);
    const FrameResult frame = many.frame(frame_of(own));
    const std::vector<Complex> z = parts.gathered(frame.z, surface.is_own());
    expect_frame_of_one(one, waves, z, frame, many.energy());
    const auto slip = many.measure().slip, expected = crease_slip(whole, waves, z);
    ASSERT_TRUE(slip);
    EXPECT_EQ(slip->mean_deg, expected->mean_deg);
    EXPECT_EQ(slip->share, expected->share);
  }
}

TEST(DistributedAnimator, HasThePhasesOfOneProcessOnModels) {
  for (const char* model : {"horse.ply", "spot.obj"}) {
    const auto path = std::filesystem::path(BRINDLE_SHARED_MODELS) / model;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    expect_phases_of_one(Parts(wavy_surface(read_mesh(path).mesh, kAxis, 100)), {});
  }
}

TEST(DistributedAnimator, SaysOfItsPhasesWhatTheLibrarySaysHoweverASurfaceIsCut) {
  const WavySurface whole = wavy_surface("trefoil,resolution=48", kAxis, 30);
  const StripePattern alone = stripe_pattern(make_surface(whole.mesh), turned(whole, 0.05f));
  for (const Cut& cut : cuts()) {
    const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
    const DistributedSurface surface = parts.surface();
    for (const std::size_t gather_below : {std::size_t{0}, std::size_t{1000}}) {
      SCOPED_TRACE(std::string(cut.name) + ", gathered below " + std::to_string(gather_below));
      DistributedOptions options = unplanned();
      options.gather_below = gather_below;
      DistributedStripeAnimator animator(surface, options);
      for (const float angle : {0.0f, 0.05f}) {
        const WaveSet waves = turned(whole, angle), own = parts.of_piece(waves);
        const FrameResult frame = animator.frame(frame_of(own));
        expect_true_metrics(parts, surface, animator, frame.z, waves);
      }
      EXPECT_LT(animator.energy(), 1.15 * alone.solution.energy);
    }
  }
}

TEST(DistributedAnimator, WorksOnSurfacesThatAreTorn) {
  const WavySurface whole = wavy_surface(torn_mesh(), kAxis, 15);
  StripeOptions stripes;
  stripes.solver.cycles = 1;
  const StripePattern alone = stripe_pattern(make_surface(whole.mesh), whole.waves, stripes);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
    const DistributedSurface surface = parts.surface();
    DistributedOptions options = unplanned();
    options.gather_below = 0;
    options.cycles = 1;
    DistributedStripeAnimator animator(surface, options);
    const WaveSet own = parts.of_piece(whole.waves);
    const FrameResult frame = animator.frame(frame_of(own));
    expect_true_metrics(parts, surface, animator, frame.z, whole.waves);
    EXPECT_LT(animator.energy(), 1.15 * alone.solution.energy);
  }
}

/// The same surface with vertices and triangles in another order.
WavySurface shuffled(const WavySurface& whole, float stripes, std::uint32_t seed) {
  std::vector<Index> to(whole.mesh.vertex_count());
  std::iota(to.begin(), to.end(), Index{0});
  std::mt19937 random(seed);
  std::ranges::shuffle(to, random);
  Mesh mesh = whole.mesh;
  for (std::size_t v = 0; v < to.size(); ++v) mesh.positions[to[v]] = whole.mesh.positions[v];
  for (Triangle& triangle : mesh.triangles) {
    for (Index& v : triangle) v = to[v];
  }
  std::ranges::shuffle(mesh.triangles, random);
  return wavy_surface(std::move(mesh), kAxis, stripes);
}

struct Sums {
  double energy = 0, branches = 0;
};

/// Of rank 0's library with the vertices in several orders, on average.
void add_orders(const WavySurface& whole, float stripes, Sums& sums) {
  constexpr std::uint32_t kOrders = 4;
  Sums more;
  for (std::uint32_t seed = 0; rank() == 0 && seed < kOrders; ++seed) {
    const WavySurface other = shuffled(whole, stripes, seed);
    const StripePattern pattern = stripe_pattern(make_surface(other.mesh), other.waves);
    more.energy += pattern.solution.energy / kOrders;
    more.branches += static_cast<double>(pattern.quality.branches) / kOrders;
  }
  MPI_Bcast(&more, 2, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  sums.energy += more.energy;
  sums.branches += more.branches;
}

/// Another order of vertices leads to other aggregates, and to another of many patterns that are as
/// good; so does a partition. Over several shapes that evens out.
TEST(DistributedAnimator, HasPatternsAsGoodAsThoseOfOneRank) {
  constexpr float kStripes = 100;
  Sums one, many;
  for (const char* shape : {"torus", "trefoil", "vessels", "molecule", "box"}) {
    const WavySurface whole = wavy_surface(shape, kAxis, kStripes);
    add_orders(whole, kStripes, one);
    const Parts parts(whole);
    const WaveSet own = parts.of_piece(whole.waves);
    const std::size_t bounds[] = {0, 4000, 16384};
    for (const std::size_t gather_below : bounds) {
      DistributedOptions options = unplanned();
      options.gather_below = gather_below;
      DistributedStripeAnimator animator(parts.surface(), options);
      animator.frame(frame_of(own));
      many.energy += animator.energy() / std::size(bounds);
      many.branches += static_cast<double>(animator.measure().quality.branches) / std::size(bounds);
    }
  }
  if (rank() == 0) {
    std::printf("energy %.4f, branches %.4f of one rank's\n", many.energy / one.energy,
                many.branches / one.branches);
  }
  EXPECT_LT(many.energy, 1.01 * one.energy);
  EXPECT_LT(many.branches, 1.03 * one.branches);
}

void expect_same_bits_in_every_run(DistributedOptions options) {
  const Parts parts(wavy_surface("molecule,resolution=40", kAxis, 60));
  const WaveSet own = parts.of_piece(parts.whole.waves);
  const WaveSet next = parts.of_piece(turned(parts.whole, 0.1f));
  std::vector<Complex> first;
  double first_energy = 0;
  for (int run = 0; run < 3; ++run) {
    const ThreadLimit threads(1 + run);
    options.cycles = 1;
    DistributedStripeAnimator animator(parts.surface(), options);
    animator.frame(frame_of(own));
    const FrameResult frame = animator.frame(frame_of(next));
    if (run == 0) {
      first.assign(frame.z.begin(), frame.z.end());
      first_energy = animator.energy();
    }
    EXPECT_TRUE(same_bits(std::span<const Complex>(first), frame.z));
    EXPECT_EQ(first_energy, animator.energy());
  }
}

TEST(DistributedAnimator, HasTheSameBitsInEveryRun) {
  expect_same_bits_in_every_run({});
  expect_same_bits_in_every_run(unplanned());
}

TEST(DistributedAnimator, FollowsTheLastFrameAsOneRankDoes) {
  const Parts parts(wavy_surface("torus", kAxis, 40));
  for (const FrameSolver solver : {FrameSolver::multilevel, FrameSolver::relaxation}) {
    DistributedOptions options = unplanned();
    options.gather_below = DistributedOptions().gather_below;
    options.solver = solver;
    StripeAnimator one(parts.whole.neighborhood, options);
    DistributedStripeAnimator many(parts.surface(), options);
    double steps_of_one = 0, steps_of_many = 0;
    for (int n = 0; n < 6; ++n) {
      const WaveSet waves = turned(parts.whole, 0.03f * static_cast<float>(n));
      const WaveSet own = parts.of_piece(waves);
      steps_of_one += one.frame(frame_of(waves)).phase_step;
      steps_of_many += many.frame(frame_of(own)).phase_step;
    }
    EXPECT_NEAR(steps_of_many, steps_of_one, 0.1 * steps_of_one);
    EXPECT_NEAR(many.energy(), one.energy(), 0.1 * one.energy());
  }
}

/// What is dealt anew goes on from phases that are given: as one process does, which is given the
/// same.
TEST(DistributedAnimator, FollowsPhasesThatAreGiven) {
  const WavySurface wavy = wavy_surface("torus,resolution=40", kAxis, 20);
  const WaveSet next = turned(wavy, 0.05f);
  StripeAnimator first(wavy.neighborhood), one(wavy.neighborhood);
  const FrameResult before = first.frame(frame_of(wavy.waves));
  const std::vector<Complex> last = matched_phases({wavy.mesh, wavy.waves, before.z}, next);
  one.set_last_phases(last);
  const FrameResult expected = one.frame(frame_of(next));
  for (const DistributedOptions& options : {DistributedOptions(), unplanned()}) {
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(cut.name);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const WaveSet own = parts.of_piece(next);
      std::vector<Complex> of_piece = parts.of_piece(last);
      DistributedStripeAnimator many(parts.surface(), options);
      many.set_last_phases(of_piece);
      const FrameResult frame = many.frame(frame_of(own));
      EXPECT_FALSE(frame.unchanged);
      if (options.plan_below > 0) {
        EXPECT_EQ(frame.phase_step, expected.phase_step);
        const std::vector<Complex> all(expected.z.begin(), expected.z.end());
        EXPECT_EQ(std::vector<Complex>(frame.z.begin(), frame.z.end()), parts.of_piece(all));
      } else {
        EXPECT_LT(frame.phase_step, 1.5 * expected.phase_step);
      }
      // Later frames follow their last one.
      EXPECT_TRUE(many.frame(frame_of(own)).unchanged);
      of_piece.push_back(1);
      EXPECT_THROW(many.set_last_phases(of_piece), Error);
      of_piece.pop_back();
      many.set_last_phases(of_piece);
      EXPECT_FALSE(many.frame(frame_of(own)).unchanged);
    }
  }
}

/// One rank, and ranks of which the first solves alone, have the bits of one process; others its
/// bounds.
void expect_another_slack_from_frame_to_frame(DistributedOptions options) {
  const Parts parts(wavy_surface("torus,resolution=40", kAxis, 20));
  const WaveSet own = parts.of_piece(parts.whole.waves);
  const WavySurface& w = parts.whole;
  options.slack = 0.3f;
  StripeAnimator one(Surface{w.mesh, w.neighborhood, w.normals}, options);
  DistributedStripeAnimator many(parts.surface(), options);
  std::vector<float> branch_penalty(w.mesh.vertex_count());
  for (std::size_t v = 0; v < branch_penalty.size(); ++v)
    branch_penalty[v] = w.mesh.positions[v].x() > 0 ? 1.0f : 0.0f;
  Slack with_penalty = 0.1f, of_piece = 0.1f;
  with_penalty.branch_penalty = branch_penalty;
  of_piece.branch_penalty = parts.of_piece(branch_penalty);
  const std::pair<Slack, Slack> steps[] = {{0.3f, 0.3f}, {0.1f, 0.1f}, {with_penalty, of_piece}};
  for (const auto& [of_one, of_many] : steps) {
    one.set_slack(of_one);
    many.set_slack(of_many);
    const FrameResult expected = one.frame(frame_of(w.waves));
    const FrameResult frame = many.frame(frame_of(own));
    EXPECT_FALSE(frame.unchanged);
    ASSERT_EQ(frame.frequencies.size(), own.frequencies.size());
    double difference = 0;
    for (std::size_t v = 0; v < own.frequencies.size(); ++v) {
      const double f = static_cast<double>(expected.frequencies[parts.ids[v]]);
      difference += std::abs(static_cast<double>(frame.frequencies[v]) / f - 1);
    }
    difference /= std::max<double>(1, static_cast<double>(own.frequencies.size()));
    EXPECT_LT(difference, rank_count() == 1 || options.plan_below > 0 ? 1e-30 : 0.01);
  }
  DistributedStripeAnimator without(parts.surface());
  EXPECT_THROW(without.set_slack(0.1f), Error);
  EXPECT_THROW(many.set_slack(-1), Error);
}

TEST(DistributedAnimator, TakesAnotherSlackFromFrameToFrame) {
  expect_another_slack_from_frame_to_frame({});
  expect_another_slack_from_frame_to_frame(unplanned());
}

void expect_phases_of_the_same_input_kept(const DistributedOptions& options) {
  const Parts parts(wavy_surface("sphere,resolution=30", kAxis, 20));
  const WaveSet own = parts.of_piece(parts.whole.waves);
  DistributedStripeAnimator animator(parts.surface(), options);
  EXPECT_FALSE(animator.frame(frame_of(own)).unchanged);
  EXPECT_TRUE(animator.frame(frame_of(own)).unchanged);
  // One rank alone has another input.
  WaveSet other = own;
  if (rank() == rank_count() - 1) other.frequencies.assign(other.frequencies.size(), 7);
  EXPECT_FALSE(animator.frame(frame_of(other)).unchanged);
  animator.restart();
  EXPECT_FALSE(animator.frame(frame_of(other)).unchanged);
}

TEST(DistributedAnimator, KeepsPhasesOfInputThatDoesNotChange) {
  expect_phases_of_the_same_input_kept({});
  expect_phases_of_the_same_input_kept(unplanned());
}

void expect_refused_on_all(const DistributedOptions& options) {
  const Parts parts(wavy_surface("sphere,resolution=30", kAxis, 20));
  WaveSet own = parts.of_piece(parts.whole.waves);
  DistributedStripeAnimator animator(parts.surface(), options);
  const FrameResult before = animator.frame(frame_of(own));
  const std::vector<Complex> z(before.z.begin(), before.z.end());
  const std::vector<Vec3> directions = own.directions;
  const int wrong = rank_count() - 1;
  if (rank() == wrong) own.directions[0] = {3, 0, 0};
  try {
    animator.frame(frame_of(own));
    FAIL() << "a direction that is no unit vector was accepted";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("vertex 0"), std::string::npos) << message;
    if (rank_count() > 1) {
      EXPECT_EQ(message.find("rank " + std::to_string(wrong)), 0u) << message;
    }
  }
  own.directions = directions;
  const FrameResult after = animator.frame(frame_of(own));
  EXPECT_TRUE(after.unchanged);
  EXPECT_TRUE(same_bits(std::span<const Complex>(z), after.z));
}

TEST(DistributedAnimator, RefusesOnAllRanksWhatOneRankGetsWrong) {
  expect_refused_on_all({});
  expect_refused_on_all(unplanned());
}

void expect_cancelled_on_all(DistributedOptions options) {
  const Parts parts(wavy_surface("sphere,resolution=60", kAxis, 20));
  const WaveSet own = parts.of_piece(parts.whole.waves);
  const WaveSet next = parts.of_piece(turned(parts.whole, 0.5f));
  options.cycles = 3;
  DistributedStripeAnimator animator(parts.surface(), options),
      undisturbed(parts.surface(), options);
  const Progress stop([](std::string_view stage, double fraction) {
    return rank() != rank_count() - 1 || stage != "cycles" || fraction < 0.5;
  });
  const Progress stop_at_once([](std::string_view, double) { return rank() != rank_count() - 1; });
  EXPECT_THROW(animator.frame(frame_of(own), stop_at_once), Cancelled);
  EXPECT_THROW(animator.energy(), Error);
  animator.frame(frame_of(own));
  undisturbed.frame(frame_of(own));
  EXPECT_THROW(animator.frame(frame_of(next), stop), Cancelled);
  EXPECT_EQ(animator.energy(), undisturbed.energy());
  const FrameResult again = animator.frame(frame_of(next));
  EXPECT_TRUE(same_bits(again.z, undisturbed.frame(frame_of(next)).z));
}

TEST(DistributedAnimator, IsCancelledOnAllRanksByOne) {
  expect_cancelled_on_all({});
  expect_cancelled_on_all(unplanned());
}

TEST(DistributedAnimator, RefusesOptionsThatItDoesNotHave) {
  const Parts parts(wavy_surface("sphere,resolution=20", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  DistributedOptions options;
  options.edge_weights = {1};
  EXPECT_THROW(DistributedStripeAnimator(surface, options), Error);
  options = {};
  options.phase_shift = PhaseShiftKind::common_source;
  EXPECT_THROW(DistributedStripeAnimator(surface, options), Error);
  options = {};
  options.lambda = -1;
  EXPECT_THROW(DistributedStripeAnimator(surface, options), Error);
}

/// A frame's sweeps over the finest level send 8 bytes for every ghost, and nothing else is sent of
/// it but waves (28 bytes), gauges and last phases.
TEST(DistributedAnimator, SendsNoMoreThanItsHaloNeeds) {
  if (rank_count() == 1) GTEST_SKIP() << "of several ranks";
  const Parts parts(wavy_surface("torus", kAxis, 40));
  const DistributedSurface surface = parts.surface();
  const auto bytes_of_frame = [&](int sweeps) {
    DistributedOptions options = unplanned();
    options.sweeps = sweeps;
    options.gather_below = 49000;  // the finest level alone is distributed
    DistributedStripeAnimator animator(surface, options);
    animator.frame(frame_of(parts.of_piece(parts.whole.waves)));
    EXPECT_EQ(animator.metrics().distributed_levels, 1u);
    const WaveSet next = parts.of_piece(turned(parts.whole, 0.1f));
    const Traffic before = surface.traffic();
    animator.frame(frame_of(next));
    std::uint64_t bytes = surface.traffic().since(before).bytes, all = 0,
                  ghosts = animator.metrics().ghosts, all_ghosts = 0;
    MPI_Allreduce(&bytes, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    MPI_Allreduce(&ghosts, &all_ghosts, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return std::pair(all, all_ghosts);
  };
  const auto [two, ghosts] = bytes_of_frame(2);
  const auto [five, same] = bytes_of_frame(5);
  EXPECT_EQ(five - two, 3 * 8 * ghosts);
}

}  // namespace
}  // namespace brindle
