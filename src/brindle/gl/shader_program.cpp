#include "brindle/gl/shader_program.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include <epoxy/gl.h>

#include "brindle/error.h"

namespace brindle {
namespace {

std::string log_of(GLuint object, decltype(glGetShaderiv) get, decltype(glGetShaderInfoLog) read) {
  GLint size = 0;
  get(object, GL_INFO_LOG_LENGTH, &size);
  std::string log(static_cast<std::size_t>(size > 0 ? size : 1), '\0');
  read(object, static_cast<GLsizei>(log.size()), nullptr, log.data());
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
  return log;
}

/// The position of an error in a driver's message, and the length of its text.
struct Place {
  std::size_t source;
  std::size_t line;
  std::size_t length;
};

/// Parses "ERROR: 0:12", "0:12(3)" or "0(12)" at the start of a message.
std::optional<Place> place_of(std::string_view message) {
  constexpr std::string_view kError = "ERROR: ";
  Place place{};
  const char* const end = message.data() + message.size();
  const char* next = message.data() + (message.starts_with(kError) ? kError.size() : 0);
  const auto file = std::from_chars(next, end, place.source);
  if (file.ec != std::errc() || file.ptr == end || (*file.ptr != ':' && *file.ptr != '('))
    return {};
  const auto line = std::from_chars(file.ptr + 1, end, place.line);
  if (line.ec != std::errc()) return {};
  next = line.ptr;
  const std::size_t closing = message.find(')', static_cast<std::size_t>(next - message.data()));
  const bool bracket = next != end && (*next == '(' || *file.ptr == '(');
  if (bracket && closing != std::string_view::npos) next = message.data() + closing + 1;
  place.length = static_cast<std::size_t>(next - message.data());
  return place;
}

GLuint compiled_shader(GLenum stage, const ShaderSources& sources) {
  std::string text = "#version 450 core\n";
  std::vector<ShaderFile> parts;
  for (const auto& [name, body] : sources) {
    if (body.empty()) throw Error("there is no shader file '" + std::string(name) + "'");
    parts.push_back({name, static_cast<std::size_t>(std::ranges::count(body, '\n'))});
    text += body;
  }
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  const std::string log = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
  glDeleteShader(shader);
  throw Error("a shader does not compile on this driver:\n" + with_file_names(log, parts));
}

GLuint linked(std::initializer_list<GLuint> shaders, std::string_view main_file) {
  const GLuint name = glCreateProgram();
  for (const GLuint shader : shaders) {
    glAttachShader(name, shader);
    glDeleteShader(shader);  // deleted together with the program
  }
  glLinkProgram(name);
  GLint success = 0;
  glGetProgramiv(name, GL_LINK_STATUS, &success);
  if (success) return name;
  const std::string log = log_of(name, glGetProgramiv, glGetProgramInfoLog);
  glDeleteProgram(name);
  throw Error("the shaders of '" + std::string(main_file) + "' do not link on this driver:\n" +
              log);
}

}  // namespace

std::string with_file_names(std::string_view log, std::span<const ShaderFile> files) {
  std::istringstream messages{std::string(log)};
  std::string result;
  for (std::string message; std::getline(messages, message);) {
    if (const auto place = place_of(message)) {
      std::size_t line = place->line - 1;
      auto file = files.begin();
      while (file != files.end() && line > file->line_count) line -= (file++)->line_count;
      if (file != files.end() && place->line > 1) {
        message =
            std::string(file->name) + ":" + std::to_string(line) + message.substr(place->length);
      }
    }
    result += (result.empty() ? "" : "\n") + message;
  }
  return result;
}

ShaderProgram::ShaderProgram(const ShaderSources& vertex, const ShaderSources& fragment) {
  const GLuint vertex_shader = compiled_shader(GL_VERTEX_SHADER, vertex);
  GLuint fragment_shader = 0;
  try {
    fragment_shader = compiled_shader(GL_FRAGMENT_SHADER, fragment);
  } catch (...) {
    glDeleteShader(vertex_shader);
    throw;
  }
  name_ = linked({vertex_shader, fragment_shader}, (fragment.end() - 1)->name);
}

ShaderProgram ShaderProgram::compute(const ShaderSources& sources) {
  return ShaderProgram(
      linked({compiled_shader(GL_COMPUTE_SHADER, sources)}, (sources.end() - 1)->name));
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(name_); }

void ShaderProgram::set(const char* uniform, bool value) const {
  glProgramUniform1i(name_, glGetUniformLocation(name_, uniform), value ? 1 : 0);
}
void ShaderProgram::set(const char* uniform, int value) const {
  glProgramUniform1i(name_, glGetUniformLocation(name_, uniform), value);
}
void ShaderProgram::set(const char* uniform, float value) const {
  glProgramUniform1f(name_, glGetUniformLocation(name_, uniform), value);
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector2i& value) const {
  glProgramUniform2iv(name_, glGetUniformLocation(name_, uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glProgramUniform2fv(name_, glGetUniformLocation(name_, uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glProgramUniform3fv(name_, glGetUniformLocation(name_, uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
  glProgramUniform4fv(name_, glGetUniformLocation(name_, uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glProgramUniformMatrix4fv(name_, glGetUniformLocation(name_, uniform), 1, GL_FALSE, value.data());
}

}  // namespace brindle
