/// What a session is: a surface, the options of its stripes, strokes and where it is looked at
/// from.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/camera.h"
#include "brindle/strokes.h"

namespace brindle::tool {

class JsonReader;

/// Values of options by their long names without the dashes, as text: one value, none for flags,
/// several for options that may be repeated.
using OptionValues = std::map<std::string, std::vector<std::string>>;

/// What a picture shows: that of `brindle stripe`, `curves` or `sample`.
enum class Shown { stripes, curves, samples };
inline constexpr std::array<Shown, 3> kAllShown = {Shown::stripes, Shown::curves, Shown::samples};

/// "stripes", "curves", "samples", and back.
std::string_view name_of(Shown shown);
/// "stripe", "curves", "sample": the command whose picture it is.
std::string_view command_of(Shown shown);
std::optional<Shown> parse_shown(std::string_view name);

/// The size of a picture, in pixels.
struct PictureSize {
  int width = 1200;
  int height = 900;

  bool operator==(const PictureSize&) const = default;
};

inline constexpr int kStoredViews = 9;

/// All that a picture follows from: equal documents give equal pictures, bit for bit.
struct SessionDocument {
  std::string mesh = "shape:trefoil";  ///< a file or shape:NAME,...
  Shown shown = Shown::stripes;
  OptionValues options;              ///< of `brindle stripe`, those that were given
  OptionValues curves;               ///< of `brindle curves`, those that it alone has
  OptionValues samples;              ///< the same of `brindle sample`
  std::vector<FieldStroke> strokes;  ///< the smooth field runs along them, and along --strokes
  /// The same, of which singularities stay where they were dragged. Windows do not show them.
  std::vector<FieldStroke> steering;
  CameraView camera;  ///< its `up` does not count: --up says it
  PictureSize size;
  std::array<std::optional<CameraView>, kStoredViews> views;  ///< under the keys 1 to 9
  /// How far frequencies follow the zoom: they are multiplied by zoom^share. 0: not at all; 1: as
  /// many stripes on the screen however near one is.
  float frequency_by_zoom = 0;
  /// Angles in radians, one per vertex: those of a pattern that followed earlier ones. Null: phases
  /// are solved for.
  std::shared_ptr<const std::vector<float>> phases;

  /// Phases by their values.
  bool operator==(const SessionDocument& other) const;
};

/// All that the smooth field runs along: first those that were drawn.
std::vector<FieldStroke> all_strokes(const SessionDocument& document);

/// Whether both have the same options, strokes and stored views: what a user would miss.
bool same_work(const SessionDocument& a, const SessionDocument& b);

/// What of `now` nobody would have any more if `after` took its place, in words: what neither has,
/// `after` nor what was saved last. "strokes", for instance.
std::vector<std::string_view> lost_work(const SessionDocument& now, const SessionDocument& saved,
                                        const SessionDocument& after);

/// Frequencies are multiplied by this.
float frequency_factor(const SessionDocument& document);

/// Throws CLI::ValidationError, naming the option and what to do, for what `brindle stripe`
/// refuses, for options that sessions do not have and for strokes, phases and numbers that have no
/// effect or are out of range. Reads no files: what is wrong with these comes out when the pattern
/// is made.
void check_document(const SessionDocument& document);

/// Turns, copies and stored views as JSON: `{"azimuth": 30, "elevation": 20, "zoom": 1}`, with
/// `"rotation": [x, y, z, w]` instead of the angles for free views, `"projection": "orthographic"`
/// and `"center": [x, y, z]` where they are not as usual.
nlohmann::ordered_json camera_to_json(const CameraView& view);
/// Throws Error naming the key and what to do; `place` is what the message calls the object.
CameraView camera_from_json(const nlohmann::json& json, const std::string& place = "camera");

nlohmann::ordered_json stroke_to_json(const FieldStroke& stroke);
FieldStroke stroke_from_json(const nlohmann::json& json, const std::string& place);

/// What documents and commands have alike, under the keys "shown", "size", "strokes" and "phases".
Shown shown_in(const JsonReader& reader);
nlohmann::ordered_json size_to_json(PictureSize size);
PictureSize size_in(const JsonReader& reader);
nlohmann::ordered_json strokes_to_json(const std::vector<FieldStroke>& strokes);
std::vector<FieldStroke> strokes_in(const JsonReader& reader, const char* key = "strokes");
nlohmann::ordered_json phases_to_json(const std::vector<float>& angles);
std::shared_ptr<const std::vector<float>> phases_in(const JsonReader& reader);

/// Options as an object: flags are true, options with several values are lists.
nlohmann::ordered_json options_to_json(const OptionValues& options);
OptionValues options_from_json(const nlohmann::json& json, const std::string& place);

nlohmann::ordered_json document_to_json(const SessionDocument& document);
/// Throws Error naming the key and what to do for unknown keys, other types and values out of
/// range, and what `check_document` finds.
SessionDocument document_from_json(const nlohmann::json& json);

/// Reads a session. Throws Error naming the file, the key and what to do.
SessionDocument read_session(const std::filesystem::path& path);
/// Writes a session, whole or not at all; what is read and written again has the same bytes.
void write_session(const std::filesystem::path& path, const SessionDocument& document);

/// The view as text for the clipboard, and back. Throws Error for text that is no view.
std::string view_text(const CameraView& view);
CameraView parse_view_text(const std::string& text);

}  // namespace brindle::tool
