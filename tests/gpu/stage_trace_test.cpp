#include "brindle/gpu/stage_trace.h"

#include "device.h"

namespace brindle {
namespace {

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
