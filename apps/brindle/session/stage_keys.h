/// What the stages of a live pattern follow from, as text: as long as it stays, so does the stage.
/// Files count with the time of their last change.
#pragma once

#include <string>

#include "session/session_options.h"

namespace brindle::tool {

/// The document's options that make one of these stages stale, and of which files they speak.
std::string options_key(const SessionDocument& document, OptionStage stages);

std::string surface_key(const SessionDocument& document);
std::string field_key(const SessionDocument& document);
std::string waves_key(const SessionDocument& document);

/// All that the phases of a document's pattern follow from. Where two documents have the same one,
/// a pattern of one is a pattern of the other.
std::string pattern_key(const SessionDocument& document);

/// Of V: what it has beside the pattern's waves.
std::string second_key(const SessionDocument& document);

/// Values that follow the camera are other ones when it moves, and heights when another axis points
/// up: both, where there are any such values.
std::string camera_key(const SessionDocument& document, OptionStage stages);

/// What curves and samples of a pattern are shown by, and how: all looks but light and slice, which
/// are the picture's alone.
std::string ornaments_key(const SessionDocument& document);

/// What other surfaces of a picture are read by, but not what they look like. Those with stripes of
/// their own have them by the document's waves.
std::string others_key(const StyleOptions& style, const std::string& waves);

/// What values of a picture are read by. Those that follow the camera are other ones when it moves,
/// and where it stands depends on all that is seen.
std::string values_key(const SessionDocument& document, const StyleOptions& style,
                       const std::string& others);

}  // namespace brindle::tool
