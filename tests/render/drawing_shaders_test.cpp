// The shaders that are installed for renderers of others (docs/gpu.md).
#include <fstream>
#include <iterator>
#include <string>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "brindle/headless_context.h"

namespace brindle {
namespace {

std::string text_of(const std::string& dialect, const std::string& stage) {
  std::ifstream in(BRINDLE_DRAWING_SHADERS "/" + dialect + "/pattern_" + stage + ".glsl");
  return {std::istreambuf_iterator<char>(in), {}};
}

void expect_compiles(GLenum kind, const std::string& text, const std::string& what) {
  const GLuint name = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(name, 1, &source, nullptr);
  glCompileShader(name);
  GLint compiled = GL_FALSE;
  glGetShaderiv(name, GL_COMPILE_STATUS, &compiled);
  char log[2000] = "";
  glGetShaderInfoLog(name, sizeof log, nullptr, log);
  EXPECT_EQ(compiled, GL_TRUE) << what << ": " << log;
  glDeleteShader(name);
}

TEST(DrawingShaders, EveryDialectCompiles) {
  const HeadlessContext context;
  const std::pair<const char*, const char*> dialects[] = {
      {"450", "#version 450 core\n"},
      {"330", "#version 330 core\n"},
      {"300es", "#version 300 es\nprecision highp float;\nprecision highp int;\n"}};
  for (const auto& [dialect, version] : dialects) {
    const std::string vertex = text_of(dialect, "vertex"), fragment = text_of(dialect, "fragment");
    ASSERT_FALSE(vertex.empty() || fragment.empty()) << dialect;
    expect_compiles(GL_VERTEX_SHADER, version + vertex + R"(
void main() { gl_Position = vec4(position_of(vertices_of(uint(gl_VertexID) / 3u).x), 1.0); })",
                    dialect);
    expect_compiles(GL_FRAGMENT_SHADER, version + fragment + R"(
flat in uint triangle;
out vec4 color;
void main() {
  SurfacePoint p = surface_point(surface_triangle(triangle), gl_FragCoord.xy, gl_FragCoord.xy);
  color = vec4(with_pattern(vec3(1.0), p), 1.0);
})",
                    dialect);
  }
}

}  // namespace
}  // namespace brindle
