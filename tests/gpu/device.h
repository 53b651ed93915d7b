/// A context and what the tests of the gpu room share in it, made once.
#pragma once

#include <gtest/gtest.h>

#include "brindle/gpu_solver.h"
#include "brindle/headless_context.h"
#include "brindle/stripe_animator.h"

namespace brindle::test {

struct Device {
  HeadlessContext context;
  GpuSolver solver;

  static Device& shared() {
    static Device device;
    return device;
  }
};

/// Every complaint of OpenGL's debug output fails the test.
class GpuTest : public testing::Test {
 protected:
  Device& device = Device::shared();

  void SetUp() override { device.context.make_current(); }
  void TearDown() override {
    EXPECT_NO_THROW(
        device.context.check_errors(testing::UnitTest::GetInstance()->current_test_info()->name()));
  }
};

inline FrameInput input_of(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

}  // namespace brindle::test
