/// OpenGL programs from the shader files embedded in the library.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace brindle {

/// The text of a file in any module's shaders/; empty for an unknown name.
std::string_view shader_text(std::string_view name);

/// A part of a shader: an embedded file, or another text with a name for messages.
struct ShaderSource {
  ShaderSource(const char* file)
      : name(file), text(shader_text(file)) {}  // NOLINT(google-explicit-constructor)
  ShaderSource(std::string_view source_name, std::string_view source_text)
      : name(source_name), text(source_text) {}

  std::string_view name;
  std::string_view text;
};

/// The parts of a shader, in order.
using ShaderSources = std::vector<ShaderSource>;

/// A linked program of a vertex and a fragment shader, or of a compute shader. Needs a current
/// OpenGL 4.5 context.
class ShaderProgram {
 public:
  /// Concatenates the sources of each shader. Throws Error with the driver's message, file and
  /// line, if compiling or linking fails.
  ShaderProgram(const ShaderSources& vertex, const ShaderSources& fragment);
  /// A compute shader. Throws as the constructor does.
  static ShaderProgram compute(const ShaderSources& sources);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  unsigned name() const { return name_; }

  /// Sets a uniform; ignores names that the program does not use.
  void set(const char* uniform, bool value) const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const Eigen::Vector2i& value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Vector4f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;

 private:
  explicit ShaderProgram(unsigned name) : name_(name) {}

  unsigned name_;
};

/// A file of a shader and its number of lines.
struct ShaderFile {
  std::string_view name;
  std::size_t line_count;
};

/// Replaces line numbers in a driver's log by file names and lines. Lines count through all files,
/// after #version as the first one: "0:12(3): error" (Mesa) and "0(12) : error" (NVIDIA) become
/// "waves.glsl:11" if that is the first file. (#line could number files, but Mesa forgets the
/// number after parsing a line.)
std::string with_file_names(std::string_view log, std::span<const ShaderFile> files);

}  // namespace brindle
