#include "brindle/gl/shader_program.h"

#include <gtest/gtest.h>

#include "brindle/base/error.h"
#include "brindle/gl/headless_context.h"

namespace brindle {
namespace {

TEST(ShaderProgram, LogsNameFileAndLine) {
  EXPECT_EQ(with_file_names("1:12(3): error: x\n0(7) : error C1: y\nnote", {"a.glsl", "b.frag"}),
            "b.frag:12: error: x\na.glsl:7 : error C1: y\nnote");
}

TEST(ShaderProgram, ShaderThatDoesNotCompileIsNamed) {
  const HeadlessContext context;
  try {
    // A fragment shader that lacks the file with its functions.
    const ShaderProgram program({"full_screen.vert"}, {"fragment_probe.frag"});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fragment_probe.frag:"), std::string::npos)
        << error.what();
  }
}

TEST(ShaderProgram, ComputeShaderThatDoesNotCompileIsNamed) {
  const HeadlessContext context;
  try {
    // Without invocation.glsl nobody knows which invocation this is.
    const ShaderProgram program = ShaderProgram::compute({"complex.glsl", "sweep.comp"});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("sweep.comp:2"), std::string::npos) << error.what();
  }
}

TEST(ShaderProgram, MissingFileIsNamed) {
  const HeadlessContext context;
  EXPECT_THROW(ShaderProgram({"no.vert"}, {"develop.frag"}), Error);
}

}  // namespace
}  // namespace brindle
