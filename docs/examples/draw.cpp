// Stripes by shaders of your own: buffers in, a picture out, and the same as the library's. Built
// and run by the tests where there is OpenGL.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "brindle/headless_context.h"
#include "brindle/normals.h"
#include "brindle/pattern_buffers.h"
#include "brindle/pattern_frames.h"
#include "brindle/renderer.h"
#include "brindle/shapes.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"

constexpr int kWidth = 800, kHeight = 600;

constexpr const char* kVertex = R"(
uniform mat4 view_from_world, clip_from_view;
flat out uint triangle;

void main() {
  triangle = uint(gl_VertexID) / 3u;
  vec3 place = position_of(vertices_of(triangle)[gl_VertexID % 3]) - origin;
  gl_Position = clip_from_view * (view_from_world * vec4(place, 1.0));
}
)";

constexpr const char* kFragment = R"(
flat in uint triangle;
out vec4 color;

void main() {
  SurfacePoint p = surface_point(surface_triangle(triangle), gl_FragCoord.xy, gl_FragCoord.xy);
  color = vec4(with_pattern(vec3(1.0), p), 1.0);
}
)";

// An installed file: of share/brindle/shaders, or of the build.
std::string shader(const std::string& dialect, const std::string& name) {
  std::ifstream in(std::string(BRINDLE_DRAWING_SHADERS) + "/" + dialect + "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

void attach(GLuint program, GLenum kind, const std::string& text) {
  const GLuint name = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(name, 1, &source, nullptr);
  glCompileShader(name);
  char log[2000] = "";
  glGetShaderInfoLog(name, sizeof log, nullptr, log);
  std::fputs(log, stderr);
  glAttachShader(program, name);
}

// What your program has anyway: a framebuffer that encodes as sRGB, and its pixels from below.
std::vector<unsigned char> drawn(int corners) {
  GLuint framebuffer, targets[2];
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, targets);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum formats[] = {GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24};
  const GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, targets[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], kWidth, kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, targets[i]);
  }
  GLuint none;
  glGenVertexArrays(1, &none);
  glBindVertexArray(none);
  glViewport(0, 0, kWidth, kHeight);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, corners);
  std::vector<unsigned char> pixels(4 * kWidth * kHeight);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

// The shares of pixels inside of the surface that differ from the library's by more than a
// hundredth.
double difference(const std::vector<unsigned char>& pixels, const brindle::Image& image) {
  int inside = 0, different = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const unsigned char* ours = &pixels[4 * ((kHeight - 1 - y) * kWidth + x)];
      const brindle::Pixel& theirs = image.at(x, y);
      if (theirs.alpha < 255 || ours[3] < 255) continue;  // the border, which the library smooths
      ++inside;
      different += std::abs(ours[0] - theirs.red) > 13;
    }
  }
  return static_cast<double>(different) / inside;
}

// The library's own shaders for a dialect, with the main functions above.
GLuint linked_program(const std::string& dialect) {
  const std::string version = "#version " + dialect + " core\n";
  const GLuint program = glCreateProgram();
  attach(program, GL_VERTEX_SHADER, version + shader(dialect, "pattern_vertex.glsl") + kVertex);
  attach(program, GL_FRAGMENT_SHADER,
         version + shader(dialect, "pattern_fragment.glsl") + kFragment);
  glLinkProgram(program);
  return program;
}

// The library's own picture, and where it was taken from.
struct Expected {
  brindle::Image image;
  brindle::Camera camera;
};

Expected expected_of(const brindle::SurfaceDrawing& drawing) {
  brindle::RenderOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.base_color = {1, 1, 1};
  options.stripe_color = {0, 0, 0};
  options.transparent = true;
  options.shading = false;
  options.quality = brindle::PictureQuality::interactive;
  return {brindle::render_picture(drawing, options),
          brindle::framed_camera(brindle::points_of_triangles(drawing.mesh), options.camera, kWidth,
                                 kHeight)};
}

// What is in the buffers, drawn by both dialects.
bool agrees(const char* what, const Expected& expected, int corners) {
  const brindle::Camera& camera = expected.camera;
  bool all = true;
  for (const std::string dialect : {"330", "450"}) {
    const GLuint program = linked_program(dialect);
    glUseProgram(program);
    const auto place = [&](const char* name) { return glGetUniformLocation(program, name); };
    glUniform1i(place("pattern_vertices"), 0);
    glUniform1i(place("pattern_triangles"), 1);
    glUniformMatrix4fv(place("view_from_world"), 1, GL_FALSE, camera.view_from_world.data());
    glUniformMatrix4fv(place("clip_from_view"), 1, GL_FALSE, camera.clip_from_view.data());
    glUniform3fv(place("origin"), 1, camera.origin.data());
    glUniform2f(place("target_size"), kWidth, kHeight);
    glUniform3f(place("stripe_color"), 0, 0, 0);
    glUniform1f(place("stripe_width"), 0.5f);
    const double share = difference(drawn(corners), expected.image);
    std::printf("%s, GLSL %s: %.3f %% of the pixels differ\n", what, dialect.c_str(), 100 * share);
    all = all && share < 0.005;
  }
  return all;
}

int main() {
  const brindle::Surface surface =
      brindle::make_surface(brindle::make_shape("sphere,resolution=16"));
  const brindle::DirectionField field =
      brindle::projected_direction_field({0.3f, 1, 0.2f}, surface.normals);
  const float frequency = 40 / bounding_box(surface.mesh).diagonal();
  const brindle::StripePattern pattern = brindle::stripe_pattern(surface, field, frequency);

  const brindle::PatternBuffers buffers =
      brindle::pattern_buffers({.positions = surface.mesh.positions,
                                .normals = surface.normals,
                                .directions = pattern.waves.directions,
                                .frequencies = pattern.waves.frequencies,
                                .z = pattern.solution.z},
                               surface.mesh.triangles, pattern.corners);

  // A frame: the surface has become longer.
  brindle::StripeAnimator animator(surface);
  brindle::PatternFrames frames(surface);
  brindle::Mesh moved = surface.mesh;
  for (brindle::Vec3& position : moved.positions) position.y() *= 1.4f;
  const std::vector<brindle::Vec3> normals = brindle::vertex_normals(moved);
  const brindle::WaveSet waves{moved.positions,
                               brindle::projected_direction_field({0.3f, 1, 0.2f}, normals),
                               pattern.waves.frequencies};
  const brindle::FrameInput input{waves.positions, waves.directions, waves.frequencies};
  const brindle::FrameResult frame = animator.frame(input);

  const Expected first = expected_of({.mesh = surface.mesh,
                                      .normals = surface.normals,
                                      .waves = &pattern.waves,
                                      .z = pattern.solution.z});
  const Expected second =
      expected_of({.mesh = moved, .normals = normals, .waves = &waves, .z = frame.z});

  const brindle::HeadlessContext context;  // your window's context, in your program
  GLuint names[2], textures[2];
  glGenBuffers(2, names);
  glBindBuffer(GL_TEXTURE_BUFFER, names[0]);
  glBufferData(GL_TEXTURE_BUFFER,
               static_cast<GLsizeiptr>(buffers.vertices.size() * sizeof(buffers.vertices[0])),
               buffers.vertices.data(), GL_DYNAMIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, names[1]);
  glBufferData(GL_TEXTURE_BUFFER,
               static_cast<GLsizeiptr>(buffers.triangles.size() * sizeof(buffers.triangles[0])),
               buffers.triangles.data(), GL_STATIC_DRAW);
  glGenTextures(2, textures);
  const GLenum formats[] = {GL_RGBA32F, GL_RGBA32UI};
  for (GLuint i = 0; i < 2; ++i) {
    glActiveTexture(GL_TEXTURE0 + i);  // for 330
    glBindTexture(GL_TEXTURE_BUFFER, textures[i]);
    glTexBuffer(GL_TEXTURE_BUFFER, formats[i], names[i]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, names[i]);  // for 450
  }
  const int corners = static_cast<int>(3 * buffers.triangles.size());
  bool all = agrees("a pattern", first, corners);

  // Into the buffer that is there.
  glBindBuffer(GL_TEXTURE_BUFFER, names[0]);
  auto* const mapped =
      static_cast<brindle::PatternVertex*>(glMapBuffer(GL_TEXTURE_BUFFER, GL_WRITE_ONLY));
  frames.fill(input, frame, {mapped, moved.vertex_count()});
  glUnmapBuffer(GL_TEXTURE_BUFFER);

  all = agrees("a frame", second, corners) && all;
  context.check_errors("the example");
  return all ? 0 : 1;
}
