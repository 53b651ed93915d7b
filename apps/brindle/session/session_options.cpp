#include "session/session_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/image.h"
#include "brindle/render/parsed_words.h"
#include "cli/described_options.h"
#include "cli/option_values.h"
#include "pictures/drawing_file.h"
#include "pictures/picture.h"

namespace brindle::tool {
namespace {

/// Options that sessions do not have, and what there is instead.
constexpr std::array<std::pair<const char*, const char*>, 14> kElsewhere = {{
    {"camera", "the session's camera says where from"},
    {"projection", "the session's camera has it"},
    {"size", "the session's size says it"},
    {"scale", "a session has pixels; give --scale to the command"},
    {"dpi", "a session has pixels; give --dpi to 'brindle render'"},
    {"quality", "pictures are fast while something moves and careful when it rests"},
    {"threads", "a session does not depend on the machine; give --threads to the command"},
    {"output", "a session has one picture; give --output to the command"},
    {"report", "a session has one picture"},
    {"quiet", "a session has one picture"},
    {"uv", "a session has one picture, and no mesh is written"},
    {"creases", "pictures of curves have none; give --creases to 'brindle curves'"},
    {"min-area", "drawings of sessions leave out what is below 0.1 square pixels"},
    {"help", "a session does not ask"},
}};

const char* elsewhere(const std::string& name) {
  for (const auto& [option, why] : kElsewhere) {
    if (name == option) return why;
  }
  return nullptr;
}

PatternJob job_of_shown(Shown shown) { return job_of(std::string(command_of(shown))); }

std::vector<const OptionInfo*> make_session_options(Shown shown) {
  std::vector<const OptionInfo*> options;
  for (const OptionInfo& info : option_table()) {
    if (info.is_for(job_of_shown(shown)) && info.stale != OptionStage::none)
      options.push_back(&info);
  }
  return options;
}

[[noreturn]] void refuse_unknown(const std::string& name, Shown shown) {
  if (const char* why = elsewhere(name)) {
    throw CLI::ValidationError("--" + name, std::string("is no option of sessions: ") + why);
  }
  std::vector<std::string> known;
  for (const OptionInfo* option : session_options(shown)) known.emplace_back(option->name);
  const std::string refusal = "is no option of 'brindle " + std::string(command_of(shown)) + "'";
  for (const Shown other : kAllShown) {
    if (find_session_option(name, other) == nullptr) continue;
    throw CLI::ValidationError(
        "--" + name, refusal + ", whose picture is shown; show " + std::string(name_of(other)));
  }
  const std::string meant = nearest(name, known);
  throw CLI::ValidationError("--" + name,
                             refusal + (meant.empty() ? "" : "; did you mean --" + meant + "?"));
}

void check_values(const std::string& name, const std::vector<std::string>& values, Shown shown) {
  const OptionInfo* option = find_session_option(name, shown);
  if (option == nullptr) refuse_unknown(name, shown);
  const std::string dashed_name = "--" + name;
  if (option->kind == OptionKind::flag) {
    if (values.empty()) return;
    throw CLI::ValidationError(dashed_name, "takes no value; give none, or leave the option out");
  }
  if (values.empty())
    throw CLI::ValidationError(dashed_name, "lacks its value " + std::string(option->form));
  if (values.size() > 1 && !option->several) {
    throw CLI::ValidationError(dashed_name,
                               "takes one value, not " + std::to_string(values.size()));
  }
  for (const std::string& value : values) {
    if (value.empty()) wrong_usage(dashed_name, std::string(option->form), value);
  }
}

/// The command line in CLI11's order, last word first.
std::vector<std::string> words_of(const SessionDocument& document) {
  std::vector<std::string> words = {document.mesh, "--"};
  for (const auto& [name, values] : shown_options(document)) {
    check_values(name, values, document.shown);
    if (values.empty()) words.push_back("--" + name);
    for (auto value = values.rbegin(); value != values.rend(); ++value) {
      words.push_back("--" + name + "=" + *value);
    }
  }
  words.emplace_back(command_of(document.shown));
  return words;
}

void check_camera(const CameraView& view, const std::string& name) {
  const auto refuse = [&](const char* what) { throw Error(name + ' ' + what); };
  if (!(view.zoom >= 0.01f && view.zoom <= 10000)) {
    refuse("must have a zoom from 0.01 to 10000");
  }
  if (!(view.elevation_deg >= -90 && view.elevation_deg <= 90)) {
    refuse("must have an elevation from -90 to 90 degrees");
  }
  if (!std::isfinite(view.azimuth_deg)) refuse("must have a finite azimuth");
  if (view.center && !view.center->allFinite()) refuse("must have a finite centre");
  if (!view.rotation) return;
  const float length = view.rotation->norm();
  if (!(length > 1e-6f && std::isfinite(length))) refuse("must have a rotation that is not zero");
}

/// Checks the parts without a command line.
void check_rest(const SessionDocument& document) {
  check_camera(document.camera, "the camera");
  for (std::size_t i = 0; i < document.views.size(); ++i) {
    if (document.views[i]) check_camera(*document.views[i], "view " + std::to_string(i + 1));
  }
  check_image_size(document.size.width, document.size.height);
  if (!(document.frequency_by_zoom >= 0 && document.frequency_by_zoom <= 1)) {
    throw Error("how far frequencies follow the zoom must be a number from 0 to 1");
  }
  if (!document.strokes.empty()) check_strokes(document.strokes);
  if (document.steering.empty()) return;
  try {
    check_strokes(document.steering);
  } catch (const Error& error) {
    throw Error("steering: " + std::string(error.what()));
  }
}

bool all_finite(const std::vector<float>& numbers) {
  return std::ranges::all_of(numbers, [](float number) { return std::isfinite(number); });
}

void check_effects(const SessionDocument& document, const StripeArguments& arguments) {
  if (!is_smooth(arguments.waves)) {
    if (!document.strokes.empty()) {
      throw Error(
          "strokes have no effect here: only --field smooth and --field curvature are drawn to "
          "anything; erase the strokes first");
    }
    if (!document.steering.empty()) {
      throw Error(
          "singularities were dragged, which only --field smooth and --field curvature follow; "
          "let them go first (Steer, 'let go')");
    }
  }
  if (!document.phases) return;
  if (!can_follow(arguments)) {
    throw Error(
        "phases are kept of plain stripes by the multilevel solver alone, without --slack and what "
        "else gives phases; leave them out");
  }
  if (!all_finite(*document.phases)) throw Error("phases must be finite angles; leave them out");
}

/// Accepts built-in tiles and files, which are read later.
void check_tile(const StripeArguments& arguments) {
  const std::string& tile = arguments.texture.tile;
  if (parse_built_in_tile(tile) || !std::filesystem::path(tile).has_extension()) {
    chosen_tile(arguments.texture, arguments.waves.cross);
  }
}

using PicturePaths = std::vector<std::filesystem::path>;

/// Stands for the session's picture, which need not be written.
const PicturePaths kShownPicture = {"session.png"};

Outputs pictures_of(const PicturePaths& paths) {
  Outputs pictures;
  for (const std::filesystem::path& path : paths) {
    pictures.push_back({path, is_drawing_file(path) ? OutputKind::drawing : OutputKind::picture});
  }
  return pictures;
}

void check_command(const ParsedSession& parsed, const PicturePaths& paths) {
  const StripeArguments& arguments = parsed.arguments();
  const Outputs pictures = pictures_of(paths);
  if (parsed.curves() != nullptr) {
    return check_curves_options(parsed.command(), *parsed.curves(), pictures);
  }
  if (parsed.samples() != nullptr) {
    return check_sample_options(parsed.command(), *parsed.samples(), pictures);
  }
  check_solver(arguments.device, arguments.solving.stripes.solver);
  check_tile(arguments);
  check_stripe_options(parsed.command(), arguments, pictures);
  // Files are known to be points only when read.
  if (arguments.surface.points) check_stripe_points(parsed.command(), arguments, pictures);
}

void check_parsed(const ParsedSession& parsed) {
  check_command(parsed, kShownPicture);
  check_own_arrays(parsed.arguments().surface, parsed.arguments().waves);
}

/// Checks that the commands of pictures not shown have their options.
void check_hidden(const SessionDocument& document) {
  for (const auto& [name, values] : document.options) check_values(name, values, Shown::stripes);
  for (const auto& [kept, shown] :
       {std::pair(&document.curves, Shown::curves), std::pair(&document.samples, Shown::samples)}) {
    for (const auto& [name, values] : *kept) {
      check_values(name, values, shown);
      if (is_own(*find_session_option(name, shown), shown)) continue;
      throw CLI::ValidationError("--" + name,
                                 "is shared by all that is shown; it belongs to "
                                 "'options', not to '" +
                                     std::string(name_of(shown)) + "'");
    }
  }
}

}  // namespace

const std::vector<const OptionInfo*>& session_options(Shown shown) {
  static const std::array<std::vector<const OptionInfo*>, kAllShown.size()> options = {
      make_session_options(Shown::stripes), make_session_options(Shown::curves),
      make_session_options(Shown::samples)};
  return options[static_cast<std::size_t>(shown)];
}

OptionValues& options_with(const std::string& name, SessionDocument& document) {
  const OptionInfo* option = find_session_option(name, document.shown);
  if (option == nullptr) refuse_unknown(name, document.shown);
  if (!is_own(*option, document.shown)) return document.options;
  return document.shown == Shown::curves ? document.curves : document.samples;
}

OptionValues shown_options(const SessionDocument& document) {
  if (document.shown == Shown::stripes) return document.options;
  OptionValues options = document.shown == Shown::curves ? document.curves : document.samples;
  for (const auto& [name, values] : document.options) {
    const OptionInfo* option = find_session_option(name, document.shown);
    if (option != nullptr && !is_own(*option, document.shown)) options[name] = values;
  }
  return options;
}

bool can_follow(const StripeArguments& arguments) {
  return can_follow_loosely(arguments) && arguments.solving.slack.slack == 0;
}

namespace {

/// Common conditions of continued patterns: frames of the multilevel solver on a mesh.
bool can_have_frames(const StripeArguments& arguments) {
  const StripeOptions& stripes = arguments.solving.stripes;
  return arguments.previous.empty() && !arguments.surface.points &&
         arguments.device == DeviceKind::cpu && stripes.solver.solver == Solver::multilevel &&
         stripes.weights == EdgeWeights::paper &&
         stripes.phase_shift != PhaseShiftKind::common_source &&
         !arguments.fabrication.change_pattern();
}

}  // namespace

bool can_follow_loosely(const StripeArguments& arguments) {
  return can_have_frames(arguments) && !has_tiles(arguments);
}

bool can_follow_tiles(const StripeArguments& arguments) {
  return can_have_frames(arguments) && has_tiles(arguments) && arguments.solving.slack.slack == 0;
}

const OptionInfo* find_session_option(const std::string& name, Shown shown) {
  const OptionInfo* option = find_option(name, job_of_shown(shown));
  return option == nullptr || option->stale == OptionStage::none ? nullptr : option;
}

bool is_own(const OptionInfo& option, Shown shown) { return option.own && shown != Shown::stripes; }

std::string in_panel_words(const std::string& text, Shown shown) {
  return with_option_names(text, [shown](const std::string& name) {
    const OptionInfo* option = find_session_option(name, shown);
    const bool is_in_panel = option != nullptr && !option->words.empty();
    return is_in_panel ? "'" + std::string(option->words) + "'" : "--" + name;
  });
}

std::vector<std::string> choices_of(const OptionInfo& option) {
  if (option.kind != OptionKind::choice) return {};
  return split(std::string(option.form), '|');
}

ParsedSession::ParsedSession(const SessionDocument& document)
    : app_(std::make_unique<CLI::App>()), arguments_(std::make_unique<StripeArguments>()) {
  command_ = app_->add_subcommand(std::string(command_of(document.shown)));
  add_options(document.shown);
  describe_options(*command_, job_of_shown(document.shown));
  if (document.mesh.empty()) throw CLI::ValidationError("MESH", "name a mesh file or a shape");
  app_->parse(words_of(document));
  PictureOptions& picture = parsed_job().picture;
  picture.render.camera = document.camera;
  picture.render.camera.up = UpAxis::y;
  stand_upright(picture, document.mesh);
  picture.render.width = document.size.width;
  picture.render.height = document.size.height;
  take_shared();
  arguments_->waves.drawn_strokes = all_strokes(document);
  arguments_->waves.frequency_factor = frequency_factor(document);
}

void ParsedSession::add_options(Shown shown) {
  switch (shown) {
    case Shown::stripes:
      return add_stripe_options(*command_, *arguments_);
    case Shown::curves:
      curves_ = std::make_unique<CurvesArguments>();
      return add_curves_options(*command_, *curves_);
    case Shown::samples:
      samples_ = std::make_unique<SampleArguments>();
      return add_sample_options(*command_, *samples_);
  }
}

JobArguments& ParsedSession::parsed_job() {
  if (curves_) return *curves_;
  if (samples_) return *samples_;
  return *arguments_;
}

void ParsedSession::take_shared() {
  if (curves_ || samples_) static_cast<JobArguments&>(*arguments_) = parsed_job();
  if (curves_) arguments_->fabrication = curves_->fabrication;
}

std::vector<UsedFile> ParsedSession::inputs() const {
  if (curves_) return curves_inputs(*curves_);
  return samples_ ? sample_inputs(*samples_) : stripe_inputs(*arguments_);
}

void check_session_points(const ParsedSession& parsed) {
  if (parsed.curves() != nullptr) return check_curves_points(*parsed.curves());
  if (parsed.samples() != nullptr) {
    if (!is_points(parsed.samples()->surface)) return;
    throw Error(
        "samples of points are not drawn, and a session shows a picture; write them with 'brindle "
        "sample'");
  }
  check_stripe_points(parsed.command(), parsed.arguments(), pictures_of(kShownPicture));
}

void check_picture_files(const ParsedSession& parsed,
                         const std::vector<std::filesystem::path>& paths) {
  for (const std::filesystem::path& path : paths) {
    if (!is_drawing_file(path) && lower_extension(path) != ".png") {
      refuse_output(path, "'" + path.extension().string() +
                              "' is no picture; write .png, or .svg or .pdf for a drawing");
    }
    if (parsed.samples() != nullptr) planned_sample(path);
    check_drawing_file(path);
  }
  check_command(parsed, paths);
}

void check_document(const SessionDocument& document, const ParsedSession& parsed) {
  check_rest(document);
  check_hidden(document);
  check_parsed(parsed);
  check_effects(document, parsed.arguments());
}

void check_document(const SessionDocument& document) {
  check_document(document, ParsedSession(document));
}

}  // namespace brindle::tool
