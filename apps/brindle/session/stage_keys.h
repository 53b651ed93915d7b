/// Keys of a live pattern's stages: a stage is valid as long as its key stays. Files enter with
/// their modification time.
#pragma once

#include <string>

#include "session/session_options.h"

namespace brindle::tool {

/// The document's options that make one of these stages stale, with stamps of their files.
std::string options_key(const SessionDocument& document, OptionStage stages);

std::string surface_key(const SessionDocument& document);
std::string field_key(const SessionDocument& document);
std::string waves_key(const SessionDocument& document);

/// All inputs of the phases of a document's pattern. Documents with the same key have
/// interchangeable patterns.
std::string pattern_key(const SessionDocument& document);

/// The camera and the up axis, if values depend on them.
std::string camera_key(const SessionDocument& document, OptionStage stages);

/// The inputs and looks of curves and samples, except for light and slice, which belong to the
/// picture.
std::string ornaments_key(const SessionDocument& document);

/// The inputs of a picture's other surfaces, without their looks. Surfaces with stripes depend on
/// the document's waves.
std::string others_key(const StyleOptions& style, const std::string& waves);

/// The inputs of a picture's values. Those that depend on the camera depend on everything that it
/// frames.
std::string values_key(const SessionDocument& document, const StyleOptions& style,
                       const std::string& others);

}  // namespace brindle::tool
