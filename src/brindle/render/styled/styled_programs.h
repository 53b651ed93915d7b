/// The shader programs of pictures in styles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "brindle/gl/shader_program.h"

namespace brindle {

/// Programs are made when they are needed for the first time: drivers take their time. `features`
/// are constants that come before the files.
class StyledPrograms {
 public:
  /// The first pass: which triangle each sample shows, of surfaces that are there as a whole.
  const ShaderProgram& whole();
  /// The same of surfaces that are discarded between their strokes, or beside their tiles: of all
  /// their triangles, or of those that `list` has put into the lists of pixels.
  enum class Parts { drawn, listed };
  const ShaderProgram& between_strokes(const std::string& features, Parts parts);
  const ShaderProgram& beside_tiles(const std::string& features, Parts parts);
  const ShaderProgram& list();

  /// Of a target with one sample a pixel, all samples of the first pass.
  const ShaderProgram& spread();

  /// The second pass: light.
  const ShaderProgram& strokes(const std::string& features, bool occlusion);
  const ShaderProgram& texture(const std::string& features, bool occlusion);

  const ShaderProgram& ground();

 private:
  using Sources = std::vector<ShaderSource>;

  const ShaderProgram& visibility(Parts parts, const char* name, const std::string& features,
                                  Sources style);
  const ShaderProgram& shading(const char* name, const std::string& features, bool occlusion,
                               Sources style);

  std::optional<ShaderProgram> whole_, list_, spread_, ground_;
  std::map<std::string, ShaderProgram> programs_;  ///< by what they are and by their features
};

}  // namespace brindle
