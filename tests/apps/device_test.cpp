#include <cstdlib>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

struct DeviceTest : ToolTest {
  nlohmann::json report_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--report", "report.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return nlohmann::json::parse(content(folder / "report.json"));
  }
};

/// Sets a variable of the environment that the tool inherits, while it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name_); }

 private:
  const char* name_;
};

TEST_F(DeviceTest, ReportsSayWhereStripesWereSolved) {
  const auto cpu = report_of({"stripe", "shape:torus,resolution=60"});
  EXPECT_EQ(cpu["device"]["kind"], "cpu");
#ifdef BRINDLE_HAS_GL
  const auto gpu = report_of({"stripe", "shape:torus,resolution=60", "--device", "gpu"});
  EXPECT_EQ(gpu["device"]["kind"], "gpu");
  EXPECT_FALSE(gpu["device"]["renderer"].get<std::string>().empty());
  EXPECT_GT(gpu["device"]["limits"]["max_shader_storage_block_size"], 0);
  EXPECT_NEAR(gpu["energy"].get<double>(), cpu["energy"].get<double>(),
              0.01 * cpu["energy"].get<double>());
#endif
}

#ifdef BRINDLE_HAS_GL

TEST_F(DeviceTest, BothSolversOfTheGpuStripe) {
  for (const char* solver : {"multilevel", "relaxation"}) {
    const auto cpu = report_of({"stripe", "shape:sphere,resolution=20", "--solver", solver});
    const auto gpu =
        report_of({"stripe", "shape:sphere,resolution=20", "--solver", solver, "--device", "gpu"});
    EXPECT_NEAR(gpu["energy"].get<double>(), cpu["energy"].get<double>(),
                0.01 * cpu["energy"].get<double>());
    EXPECT_EQ(gpu["iterations"], cpu["iterations"]);
  }
}

TEST_F(DeviceTest, ScenesPlayOnTheGpu) {
  const std::vector<std::string> scene = {"animate", "shape:torus,resolution=60", "--frames", "4",
                                          "--compare-from-scratch"};
  const auto cpu = report_of(scene);
  std::vector<std::string> on_gpu = scene;
  on_gpu.insert(on_gpu.end(), {"--device", "gpu", "--output", "%d.png", "--size", "80x60"});
  const auto gpu = report_of(on_gpu);
  EXPECT_EQ(gpu["device"]["kind"], "gpu");
  for (std::size_t n = 0; n < 4; ++n) {
    const double energy = cpu["frames"][n]["energy"];
    EXPECT_NEAR(gpu["frames"][n]["energy"].get<double>(), energy, 0.01 * energy) << n;
    const double step = cpu["frames"][n]["phase_step"];
    EXPECT_NEAR(gpu["frames"][n]["phase_step"].get<double>(), step, 0.05 * step + 1e-5) << n;
    EXPECT_TRUE(listing().contains(std::to_string(n) + ".png"));
  }
}

TEST_F(DeviceTest, SolversThatTheGpuHasNotAreWrongUsage) {
  expect_refusal(2, "the GPU solves by multilevel or relaxation",
                 {"stripe", "shape:torus,resolution=8", "--device", "gpu", "--solver", "averaged"});
}

TEST_F(DeviceTest, NoOpenGlAtAllIsAnErrorThatNamesTheRemedy) {
  const Variable none("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null");
  for (const char* command : {"stripe", "animate"}) {
    expect_refusal(1, "install a GPU driver",
                   {command, "shape:torus,resolution=8", "--device", "gpu"});
  }
}

TEST_F(DeviceTest, OlderOpenGlIsNamed) {
  const Variable old("MESA_GL_VERSION_OVERRIDE", "3.3");
  const ToolResult result = run({"stripe", "shape:torus,resolution=8", "--device", "gpu", "-q"});
  if (result.exit_code == 0) GTEST_SKIP() << "this driver is not Mesa's";
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("no OpenGL 4.5 core context"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("OpenGL 3.3"), std::string::npos) << result.err;
}

#endif

TEST_F(DeviceTest, UnknownDevicesAreWrongUsage) {
  expect_refusal(2, "cpu|gpu", {"stripe", "shape:torus,resolution=8", "--device", "tpu"});
}

}  // namespace
}  // namespace brindle::test
