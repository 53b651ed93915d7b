#include "brindle/gl/shader_program.h"

#include <array>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/headless_context.h"

namespace brindle {
namespace {

TEST(ShaderProgram, LogsNameFileAndLine) {
  const std::array<ShaderFile, 2> files{{{"a.glsl", 10}, {"b.frag", 20}}};
  EXPECT_EQ(with_file_names("0:12(3): error: x\n0(11) : error C1: y\nERROR: 0:2: z\nnote", files),
            "b.frag:1: error: x\na.glsl:10 : error C1: y\na.glsl:1: z\nnote");
  EXPECT_EQ(with_file_names("0:1(1): in #version", files), "0:1(1): in #version");
  EXPECT_EQ(with_file_names("0:99(1): beyond", files), "0:99(1): beyond");
}

TEST(ShaderProgram, ShaderThatDoesNotCompileIsNamed) {
  const HeadlessContext context;
  try {
    // A fragment shader that lacks the file with its functions.
    const ShaderProgram program({"full_screen.vert"}, {"shade.frag"});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("shade.frag:"), std::string::npos) << error.what();
  }
}

TEST(ShaderProgram, ComputeShaderThatDoesNotCompileIsNamed) {
  const HeadlessContext context;
  try {
    // Without invocation.glsl nobody knows which invocation this is.
    const ShaderProgram program = ShaderProgram::compute({"complex.glsl", "sweep.comp"});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("sweep.comp:4"), std::string::npos) << error.what();
  }
}

TEST(ShaderProgram, MissingFileIsNamed) {
  const HeadlessContext context;
  EXPECT_THROW(ShaderProgram({"no.vert"}, {"develop.frag"}), Error);
}

}  // namespace
}  // namespace brindle
