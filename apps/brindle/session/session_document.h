/// The content of a session: a surface, options, strokes and cameras.
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

/// Option values as text, by long name without dashes: one value, none for flags, several for
/// repeatable options.
using OptionValues = std::map<std::string, std::vector<std::string>>;

/// The picture: of `brindle stripe`, `curves` or `sample`.
enum class Shown { stripes, curves, samples };
inline constexpr std::array<Shown, 3> kAllShown = {Shown::stripes, Shown::curves, Shown::samples};

/// "stripes", "curves", "samples", and back.
std::string_view name_of(Shown shown);
/// The command of the picture: "stripe", "curves", "sample".
std::string_view command_of(Shown shown);
std::optional<Shown> parse_shown(std::string_view name);

/// The size of a picture, in pixels.
struct PictureSize {
  int width = 1200;
  int height = 900;

  bool operator==(const PictureSize&) const = default;
};

inline constexpr int kStoredViews = 9;

/// All inputs of a picture: equal documents give equal pictures, bit for bit.
struct SessionDocument {
  std::string mesh = "shape:trefoil";  ///< a file or shape:NAME,...
  Shown shown = Shown::stripes;
  OptionValues options;              ///< given options of `brindle stripe`
  OptionValues curves;               ///< given options of `brindle curves` alone
  OptionValues samples;              ///< the same of `brindle sample`
  std::vector<FieldStroke> strokes;  ///< guide the smooth field, with those of --strokes
  /// Strokes that fix dragged singularities. Windows do not show them.
  std::vector<FieldStroke> steering;
  CameraView camera;  ///< `up` is unused: see --up
  PictureSize size;
  std::array<std::optional<CameraView>, kStoredViews> views;  ///< under the keys 1 to 9
  /// Exponent by which frequencies follow the zoom: they are multiplied by zoom^share. 0: no
  /// change; 1: constant number of stripes on the screen.
  float frequency_by_zoom = 0;
  /// Phases in radians, one per vertex, of a pattern that continued earlier ones. Null: solve for
  /// them.
  std::shared_ptr<const std::vector<float>> phases;

  /// Compares phases by value.
  bool operator==(const SessionDocument& other) const;
};

/// All strokes that guide the smooth field, drawn ones first.
std::vector<FieldStroke> all_strokes(const SessionDocument& document);

/// Whether both have the same options, strokes and stored views: the user's work.
bool same_work(const SessionDocument& a, const SessionDocument& b);

/// Names of the work in `now` that would be lost if `after` replaced it: in neither `after` nor
/// `saved`. For example "strokes".
std::vector<std::string_view> lost_work(const SessionDocument& now, const SessionDocument& saved,
                                        const SessionDocument& after);

/// The factor of all frequencies.
float frequency_factor(const SessionDocument& document);

/// Throws CLI::ValidationError with the option and the remedy for what `brindle stripe` rejects,
/// for options that sessions do not have, and for strokes, phases and numbers without effect or out
/// of range. Reads no files; their errors appear when the pattern is made.
void check_document(const SessionDocument& document);

/// Cameras as JSON: `{"azimuth": 30, "elevation": 20, "zoom": 1}`; free views have `"rotation": [x,
/// y, z, w]` instead of the angles; `"projection": "orthographic"` and `"center": [x, y, z]` only
/// if not the default.
nlohmann::ordered_json camera_to_json(const CameraView& view);
/// Throws Error with the key and the remedy; `place` names the object in messages.
CameraView camera_from_json(const nlohmann::ordered_json& json,
                            const std::string& place = "camera");

nlohmann::ordered_json stroke_to_json(const FieldStroke& stroke);
FieldStroke stroke_from_json(const nlohmann::ordered_json& json, const std::string& place);

/// Common keys of documents and commands: "shown", "size", "strokes" and "phases".
Shown shown_in(const JsonReader& reader);
nlohmann::ordered_json size_to_json(PictureSize size);
PictureSize size_in(const JsonReader& reader);
nlohmann::ordered_json strokes_to_json(const std::vector<FieldStroke>& strokes);
std::vector<FieldStroke> strokes_in(const JsonReader& reader, const char* key = "strokes");
nlohmann::ordered_json phases_to_json(const std::vector<float>& angles);
std::shared_ptr<const std::vector<float>> phases_in(const JsonReader& reader);

/// Options as an object: flags are true, options with several values are lists.
nlohmann::ordered_json options_to_json(const OptionValues& options);
OptionValues options_from_json(const nlohmann::ordered_json& json, const std::string& place);

nlohmann::ordered_json document_to_json(const SessionDocument& document);
/// Throws Error with the key and the remedy for unknown keys, other types and values out of range,
/// and what `check_document` throws.
SessionDocument document_from_json(const nlohmann::ordered_json& json);

/// Reads a session. Throws Error with the file, the key and the remedy.
SessionDocument read_session(const std::filesystem::path& path);
/// Writes a session atomically; reading and writing it again gives the same bytes.
void write_session(const std::filesystem::path& path, const SessionDocument& document);

/// The view as text for the clipboard, and back. Throws Error for other text.
std::string view_text(const CameraView& view);
CameraView parse_view_text(const std::string& text);

}  // namespace brindle::tool
