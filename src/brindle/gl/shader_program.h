/// OpenGL programs from the shader files embedded in the library.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace brindle {

/// The text of a file in any room's shaders/; empty if there is none of that name.
std::string_view shader_text(std::string_view name);

/// A part of a shader: an embedded file, or a text of its own with a name for messages.
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
  /// Each shader is its sources one after the other.
  /// Throws Error with the driver's message, naming file and line, if they do not compile or link.
  ShaderProgram(const ShaderSources& vertex, const ShaderSources& fragment);
  /// A compute shader. Throws as the constructor does.
  static ShaderProgram compute(const ShaderSources& sources);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  unsigned name() const { return name_; }

  /// Sets a uniform; names that the program does not use are ignored.
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

/// A file of a shader and how many lines it has.
struct ShaderFile {
  std::string_view name;
  std::size_t line_count;
};

/// Puts file names into a driver's log, which counts lines through all files after the first line
/// of all, #version: "0:12(3): error" (Mesa) and "0(12) : error" (NVIDIA) begin with
/// "waves.glsl:11" if that is the first file. (#line would number files, but Mesa forgets that
/// number once a line has been parsed.)
std::string with_file_names(std::string_view log, std::span<const ShaderFile> files);

}  // namespace brindle
