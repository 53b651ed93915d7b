#include "brindle/gpu/stage_trace.h"

#include <map>

#include "brindle/gpu/gpu_topology.h"
#include "device.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

using FrameTrafficTest = test::GpuTest;

std::map<std::string_view, std::size_t> traffic(const Hierarchy& hierarchy, int sweeps) {
  const auto stages = frame_traffic(*topology_of(hierarchy, sweeps));
  return {stages.begin(), stages.end()};
}

TEST_F(FrameTrafficTest, EverySweepMovesTheSameBytesAndNoOtherStageAny) {
  const Hierarchy hierarchy =
      build_hierarchy(wavy_surface("torus,resolution=120", Vec3(0.31f, 0.9f, 0.27f), 25).graph());
  auto none = traffic(hierarchy, 0), two = traffic(hierarchy, 2), four = traffic(hierarchy, 4);
  for (const char* stage : {"load", "couple", "sums", "nodes"}) {
    EXPECT_EQ(none[stage], four[stage]) << stage;
    EXPECT_GT(none[stage], 0u) << stage;
  }
  for (const char* stage : {"sweeps", "small levels"}) {
    EXPECT_GT(two[stage], none[stage]);
    EXPECT_EQ(four[stage] - two[stage], two[stage] - none[stage]);
  }
  // A sweep cannot do with less than couplings and neighbours.
  EXPECT_GT((two["sweeps"] - none["sweeps"]) / 2, 12 * hierarchy.levels[0].layout().entry_count());
}

using StageTimerTest = test::GpuTest;

TEST_F(StageTimerTest, StagesOfOneNameCountTogetherInTheOrderOfTheirFirst) {
  StageTimer timer;
  for (int run = 0; run < 2; ++run) {
    timer.start();
    for (const char* stage : {"up", "down", "up"}) timer.stage(stage);
    const auto times = timer.milliseconds();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].first, "up");
    EXPECT_EQ(times[1].first, "down");
    for (const auto& [name, milliseconds] : times) EXPECT_GE(milliseconds, 0) << name;
  }
}

TEST_F(StageTimerTest, NothingTakesNoTime) {
  StageTimer timer;
  EXPECT_TRUE(timer.milliseconds().empty());
}

}  // namespace
}  // namespace brindle
