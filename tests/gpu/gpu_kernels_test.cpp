#include "brindle/gpu/gpu_kernels.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <epoxy/gl.h>

#include "brindle/error.h"
#include "device.h"

namespace brindle {
namespace {

using GpuKernelsTest = test::GpuTest;

TEST_F(GpuKernelsTest, GroupsCoverAllInvocations) {
  for (const std::size_t wanted :
       {0ul, 1ul, 64ul, 65ul, 64ul * 65535, 64ul * 65535 + 1, 1ul << 30}) {
    const GpuGroups groups = GpuGroups::of(wanted);
    EXPECT_GE(groups.count() * GpuKernels::kGroupSize, wanted);
    EXPECT_LE(groups.count(), wanted / GpuKernels::kGroupSize + groups.y);
    EXPECT_LE(groups.x, 65535u);
    EXPECT_LE(groups.y, 65535u);
  }
}

TEST_F(GpuKernelsTest, NoShaderNeedsMoreStorageBlocksThanEveryDeviceHas) {
  const GpuKernels& k = *device.solver.kernels();
  for (const ShaderProgram* kernel :
       {&k.load_waves, &k.couple, &k.couple_common_source, &k.gauges, &k.gauge_rows, &k.sums,
        &k.keep_phases, &k.renew_small, &k.descend_small, &k.prolong, &k.sweep, &k.relax,
        &k.judge_iteration, &k.to_nodes, &k.measure, &k.sum_parts}) {
    GLint blocks = 0;
    glGetProgramInterfaceiv(kernel->name(), GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
    EXPECT_GT(blocks, 0);
    EXPECT_LE(blocks, 8);
  }
}

TEST_F(GpuKernelsTest, AShaderThatDoesNotCompileNamesItsFileAndLine) {
  try {
    // Without levels.glsl nobody knows what a level is.
    ShaderProgram::compute({"invocation.glsl", "complex.glsl", "sweep.glsl", "sweep.comp"});
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string_view text = shader_text("sweep.glsl");
    const auto line = 1 + std::ranges::count(text.substr(0, text.find("(Level ")), '\n');
    EXPECT_NE(std::string(error.what()).find("sweep.glsl:" + std::to_string(line)),
              std::string::npos)
        << error.what();
  }
  // Some drivers complain a second time, here.
  try {
    device.context.check_errors("compiling");
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("compiling"), std::string::npos);
  }
}

}  // namespace
}  // namespace brindle
