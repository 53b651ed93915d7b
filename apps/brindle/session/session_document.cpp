#include "session/session_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "brindle/base/base64.h"
#include "brindle/base/elementary.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/image.h"
#include "session/json_reader.h"

namespace brindle::tool {
namespace {

constexpr int kFormat = 1;
constexpr std::array<std::string_view, kAllShown.size()> kShownNames = {"stripes", "curves",
                                                                        "samples"};
constexpr std::array<std::string_view, kAllShown.size()> kCommands = {"stripe", "curves", "sample"};
constexpr double kLargest = std::numeric_limits<float>::max();

nlohmann::ordered_json to_json(const Vec3& v) {
  return {short_number(v.x()), short_number(v.y()), short_number(v.z())};
}

void read_views(const JsonReader& reader, SessionDocument& document) {
  const nlohmann::ordered_json& views = reader.at("views");
  const JsonReader by_key(views, "views");
  by_key.allow({"1", "2", "3", "4", "5", "6", "7", "8", "9"});
  for (const auto& [key, view] : views.items()) {
    document.views[static_cast<std::size_t>(key[0] - '1')] = camera_from_json(view, "views." + key);
  }
}

nlohmann::ordered_json views_to_json(const SessionDocument& document) {
  auto views = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < document.views.size(); ++i) {
    if (document.views[i]) views[std::to_string(i + 1)] = camera_to_json(*document.views[i]);
  }
  return views;
}

void check_format(const JsonReader& reader) {
  if (!reader.has("brindle_session")) {
    throw Error("this is no session: it lacks 'brindle_session': " + std::to_string(kFormat));
  }
  if (reader.number("brindle_session") != kFormat) {
    reader.fail("brindle_session", "must be " + std::to_string(kFormat) +
                                       ", the format that this version reads; save it again with "
                                       "the version that wrote it");
  }
}

}  // namespace

std::string_view name_of(Shown shown) { return kShownNames[static_cast<std::size_t>(shown)]; }

std::string_view command_of(Shown shown) { return kCommands[static_cast<std::size_t>(shown)]; }

std::optional<Shown> parse_shown(std::string_view name) {
  for (const Shown shown : kAllShown) {
    if (name_of(shown) == name) return shown;
  }
  return std::nullopt;
}

bool SessionDocument::operator==(const SessionDocument& other) const {
  const bool same_phases =
      phases == other.phases || (phases && other.phases && *phases == *other.phases);
  return same_phases && mesh == other.mesh && shown == other.shown && options == other.options &&
         curves == other.curves && samples == other.samples && strokes == other.strokes &&
         steering == other.steering && camera == other.camera && size == other.size &&
         views == other.views && frequency_by_zoom == other.frequency_by_zoom;
}

namespace {

/// Work that a user would lose.
struct WorkPart {
  std::string_view words;
  bool (*same)(const SessionDocument& a, const SessionDocument& b);
};

constexpr std::array<WorkPart, 3> kWork = {{
    {"options",
     [](const SessionDocument& a, const SessionDocument& b) {
       return a.options == b.options && a.curves == b.curves && a.samples == b.samples &&
              a.frequency_by_zoom == b.frequency_by_zoom;
     }},
    {"strokes",
     [](const SessionDocument& a, const SessionDocument& b) {
       return a.strokes == b.strokes && a.steering == b.steering;
     }},
    {"stored views",
     [](const SessionDocument& a, const SessionDocument& b) { return a.views == b.views; }},
}};

}  // namespace

std::vector<FieldStroke> all_strokes(const SessionDocument& document) {
  std::vector<FieldStroke> all = document.strokes;
  all.insert(all.end(), document.steering.begin(), document.steering.end());
  return all;
}

bool same_work(const SessionDocument& a, const SessionDocument& b) {
  return std::ranges::all_of(kWork, [&](const WorkPart& part) { return part.same(a, b); });
}

std::vector<std::string_view> lost_work(const SessionDocument& now, const SessionDocument& saved,
                                        const SessionDocument& after) {
  std::vector<std::string_view> lost;
  for (const WorkPart& part : kWork) {
    if (!part.same(now, saved) && !part.same(now, after)) lost.push_back(part.words);
  }
  return lost;
}

float frequency_factor(const SessionDocument& document) {
  if (document.frequency_by_zoom == 0) return 1;
  return elementary::pow(document.camera.zoom, document.frequency_by_zoom);
}

nlohmann::ordered_json camera_to_json(const CameraView& view) {
  nlohmann::ordered_json json;
  if (view.rotation) {
    const Eigen::Quaternionf& r = *view.rotation;
    json["rotation"] = {short_number(r.x()), short_number(r.y()), short_number(r.z()),
                        short_number(r.w())};
  } else {
    json["azimuth"] = short_number(view.azimuth_deg);
    json["elevation"] = short_number(view.elevation_deg);
  }
  json["zoom"] = short_number(view.zoom);
  if (view.projection == Projection::orthographic) json["projection"] = "orthographic";
  if (view.center) json["center"] = to_json(*view.center);
  return json;
}

CameraView camera_from_json(const nlohmann::ordered_json& json, const std::string& place) {
  const JsonReader reader(json, place);
  CameraView view;
  if (reader.has("rotation")) {
    reader.allow({"rotation", "zoom", "projection", "center"});
    const std::vector<double> r = reader.numbers("rotation", 4);
    view.rotation = Eigen::Quaternionf(static_cast<float>(r[3]), static_cast<float>(r[0]),
                                       static_cast<float>(r[1]), static_cast<float>(r[2]));
    const float length = view.rotation->norm();
    if (!(length > 1e-6f && std::isfinite(length))) {
      reader.fail("rotation", "must be four finite numbers x, y, z, w, not all zero");
    }
  } else {
    reader.allow({"azimuth", "elevation", "zoom", "projection", "center"});
    view.azimuth_deg = reader.number("azimuth", -kLargest, kLargest);
    view.elevation_deg = reader.number("elevation", -90, 90);
  }
  if (reader.has("zoom")) view.zoom = reader.number("zoom", 0.01, 10000);
  if (reader.has("projection")) {
    const std::string projection = reader.text("projection");
    if (projection != "perspective" && projection != "orthographic") {
      reader.fail("projection", "must be perspective or orthographic");
    }
    if (projection == "orthographic") view.projection = Projection::orthographic;
  }
  if (reader.has("center")) {
    const std::vector<double> c = reader.numbers("center", 3);
    view.center = Eigen::Vector3d(c[0], c[1], c[2]).cast<float>();
    if (!view.center->allFinite()) reader.fail("center", "must be three numbers in range");
  }
  return view;
}

nlohmann::ordered_json stroke_to_json(const FieldStroke& stroke) {
  auto points = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& p : stroke.points) {
    points.push_back({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0});
  }
  return {{"radius", stroke.radius}, {"strength", stroke.strength}, {"points", std::move(points)}};
}

FieldStroke stroke_from_json(const nlohmann::ordered_json& json, const std::string& place) {
  const JsonReader reader(json, place);
  reader.allow({"radius", "strength", "points"});
  FieldStroke stroke;
  stroke.radius = reader.number("radius");
  if (reader.has("strength")) stroke.strength = reader.number("strength");
  std::size_t number = 0;
  for (const nlohmann::ordered_json& point : reader.list("points")) {
    const bool fits = point.is_array() && point.size() == 3 &&
                      std::ranges::all_of(point, [](const auto& x) { return x.is_number(); });
    if (!fits) {
      reader.fail("points[" + std::to_string(number) + "]", "must be a list of 3 numbers x, y, z");
    }
    stroke.points.emplace_back(point[0].get<double>(), point[1].get<double>(),
                               point[2].get<double>());
    ++number;
  }
  return stroke;
}

nlohmann::ordered_json size_to_json(PictureSize size) { return {size.width, size.height}; }

PictureSize size_in(const JsonReader& reader) {
  const std::vector<double> sides = reader.numbers("size", 2);
  for (const double side : sides) {
    if (!(side >= 1 && side <= kMaxImageSide && side == std::floor(side))) {
      reader.fail("size",
                  "must be two whole numbers of pixels from 1 to " + std::to_string(kMaxImageSide));
    }
  }
  return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

nlohmann::ordered_json strokes_to_json(const std::vector<FieldStroke>& strokes) {
  auto json = nlohmann::ordered_json::array();
  for (const FieldStroke& stroke : strokes) json.push_back(stroke_to_json(stroke));
  return json;
}

std::vector<FieldStroke> strokes_in(const JsonReader& reader, const char* key) {
  std::vector<FieldStroke> strokes;
  for (const nlohmann::ordered_json& stroke : reader.list(key)) {
    strokes.push_back(
        stroke_from_json(stroke, std::string(key) + "[" + std::to_string(strokes.size()) + "]"));
  }
  return strokes;
}

nlohmann::ordered_json phases_to_json(const std::vector<float>& angles) {
  std::string text;
  OutputStream out(text);
  Base64Writer base64(out);
  base64.put(angles.data(), angles.size() * sizeof(float));
  base64.finish();
  return text;
}

std::shared_ptr<const std::vector<float>> phases_in(const JsonReader& reader) {
  const std::optional<std::string> bytes = base64_decoded(reader.text("phases"));
  if (!bytes || bytes->size() % sizeof(float) != 0) {
    reader.fail("phases",
                "must be 32-bit numbers in base64; leave it out to have the phases solved for");
  }
  std::vector<float> angles(bytes->size() / sizeof(float));
  std::memcpy(angles.data(), bytes->data(), bytes->size());
  return std::make_shared<const std::vector<float>>(std::move(angles));
}

Shown shown_in(const JsonReader& reader) {
  const std::optional<Shown> shown = parse_shown(reader.text("shown"));
  if (!shown) reader.fail("shown", "must be stripes, curves or samples");
  return *shown;
}

nlohmann::ordered_json options_to_json(const OptionValues& options) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, values] : options) {
    if (values.empty()) {
      json[name] = true;
    } else if (values.size() == 1) {
      json[name] = values.front();
    } else {
      json[name] = values;
    }
  }
  return json;
}

OptionValues options_from_json(const nlohmann::ordered_json& json, const std::string& place) {
  const JsonReader reader(json, place);
  OptionValues options;
  for (const auto& [name, value] : json.items()) {
    if (value.is_boolean() && value.get<bool>()) {
      options[name] = {};
    } else if (value.is_string()) {
      options[name] = {value.get<std::string>()};
    } else if (value.is_array() && !value.empty()) {
      options[name] = reader.texts(name.c_str());
    } else {
      reader.fail(name, "must be text, as on the command line, true of a flag, or a list of texts");
    }
  }
  return options;
}

nlohmann::ordered_json document_to_json(const SessionDocument& document) {
  nlohmann::ordered_json json = {{"brindle_session", kFormat}, {"mesh", document.mesh}};
  if (document.shown != Shown::stripes) json["shown"] = name_of(document.shown);
  json["options"] = options_to_json(document.options);
  if (!document.curves.empty()) json["curves"] = options_to_json(document.curves);
  if (!document.samples.empty()) json["samples"] = options_to_json(document.samples);
  json["camera"] = camera_to_json(document.camera);
  json["size"] = size_to_json(document.size);
  if (document.frequency_by_zoom != 0) {
    json["frequency_by_zoom"] = short_number(document.frequency_by_zoom);
  }
  nlohmann::ordered_json views = views_to_json(document);
  if (!views.empty()) json["views"] = std::move(views);
  if (!document.strokes.empty()) json["strokes"] = strokes_to_json(document.strokes);
  if (!document.steering.empty()) json["steering"] = strokes_to_json(document.steering);
  if (document.phases) json["phases"] = phases_to_json(*document.phases);
  return json;
}

SessionDocument document_from_json(const nlohmann::ordered_json& json) {
  const JsonReader reader(json, "");
  check_format(reader);
  reader.allow({"brindle_session", "mesh", "shown", "options", "curves", "samples", "camera",
                "size", "frequency_by_zoom", "views", "strokes", "steering", "phases"});
  SessionDocument document;
  document.mesh = reader.text("mesh");
  if (reader.has("shown")) document.shown = shown_in(reader);
  if (reader.has("options")) document.options = options_from_json(reader.at("options"), "options");
  if (reader.has("curves")) document.curves = options_from_json(reader.at("curves"), "curves");
  if (reader.has("samples")) document.samples = options_from_json(reader.at("samples"), "samples");
  if (reader.has("camera")) document.camera = camera_from_json(reader.at("camera"));
  if (reader.has("size")) document.size = size_in(reader);
  if (reader.has("frequency_by_zoom")) {
    document.frequency_by_zoom = reader.number("frequency_by_zoom", 0, 1);
  }
  if (reader.has("views")) read_views(reader, document);
  if (reader.has("strokes")) document.strokes = strokes_in(reader);
  if (reader.has("steering")) document.steering = strokes_in(reader, "steering");
  if (reader.has("phases")) document.phases = phases_in(reader);
  check_document(document);
  return document;
}

SessionDocument read_session(const std::filesystem::path& path) {
  InputFile file(path);
  const auto size = static_cast<std::size_t>(file.size());
  const std::string text(file.take(size), size);
  try {
    return document_from_json(parse_json(text));
  } catch (const std::exception& error) {
    throw Error(shown(path.native()) + ": " + error.what());
  }
}

void write_session(const std::filesystem::path& path, const SessionDocument& document) {
  check_document(document);
  std::string text;
  try {
    text = document_to_json(document).dump(2);
  } catch (const nlohmann::json::exception&) {  // invalid UTF-8
    throw Error(shown(path.native()) +
                ": cannot be written, because a session holds names in UTF-8 alone, and the mesh's "
                "or another file's is not; rename it");
  }
  write_file(path, [&](OutputStream& out) { out << text << '\n'; });
}

std::string view_text(const CameraView& view) { return camera_to_json(view).dump(); }

CameraView parse_view_text(const std::string& text) {
  return camera_from_json(parse_json(text), "view");
}

}  // namespace brindle::tool
