#include "fuzzed_session.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "brindle/error.h"
#include "bytes.h"
#include "promises.h"
#include "scratch.h"
#include "session/live_pattern.h"
#include "session/session.h"
#include "session/session_options.h"

namespace brindle::fuzz {
namespace {

using namespace tool;

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What tools refuse as wrong usage is refused here, too.
template <typename Work>
void refusing(const Work& work) {
  try {
    work();
  } catch (const CLI::ParseError& error) {
    throw Error(error.what());
  }
}

/// Numbers of a row: mostly where its slider is, at the ends of its range now and then, or beyond.
std::string fuzzed_number(Bytes& bytes, const OptionInfo& option) {
  const double share = bytes.byte() / 255.0;
  double value = option.slider.lowest + share * (option.slider.highest - option.slider.lowest);
  switch (bytes.below(12)) {
    case 0:
      value = option.range.least;
      break;
    case 1:
      value = std::min(option.range.most, 1e3);
      break;
    case 2:
      value = bytes.number();
      break;
  }
  if (option.kind == OptionKind::whole) value = std::round(value);
  std::string text = std::to_string(value);
  if (option.kind == OptionKind::whole) text = text.substr(0, text.find('.'));
  if (option.kind == OptionKind::length && bytes.flag()) text += "%";
  return text;
}

std::string fuzzed_text(Bytes& bytes) {
  static constexpr const char* kTexts[] = {"array:normal", "array:height", "array:none", "smooth",
                                           "axis",         "1,0,0",        "0,0,1",      "u",
                                           "curvature",    "#ff8800",      "none",       "0.5",
                                           "viridis",      "no-such-file", "arrows",     "dots"};
  return kTexts[bytes.below(std::size(kTexts))];
}

std::string fuzzed_value(Bytes& bytes, const OptionInfo& option) {
  if (option.kind == OptionKind::choice) {
    const auto choices = choices_of(option);
    if (!choices.empty()) return choices[bytes.below(choices.size())];
  }
  const bool is_number = option.kind == OptionKind::whole || option.kind == OptionKind::number ||
                         option.kind == OptionKind::length;
  if (is_number) return fuzzed_number(bytes, option);
  if (option.kind == OptionKind::numbers) {
    const std::string first = fuzzed_number(bytes, option);
    const bool is_range = option.form.find("..") != option.form.npos;
    return first + (is_range ? ".." : ",") + fuzzed_number(bytes, option);
  }
  return fuzzed_text(bytes);
}

SessionCommand fuzzed_option(Bytes& bytes, Shown shown) {
  const auto& options = session_options(shown);
  const OptionInfo& option = *options[(bytes.byte() << 8 | bytes.byte()) % options.size()];
  const std::string name(option.name);
  if (bytes.below(4) == 0) return commands::clear_option(name);
  if (option.kind == OptionKind::flag) return commands::set_option(name);
  return commands::set_option(name, {fuzzed_value(bytes, option)});
}

FieldStroke fuzzed_stroke(Bytes& bytes) {
  FieldStroke stroke;
  for (std::size_t count = 1 + bytes.below(3); count > 0; --count) {
    stroke.points.push_back(bytes.vector().cast<double>() / 4);
  }
  stroke.radius = std::abs(bytes.number()) / 8;
  stroke.strength = bytes.number();
  return stroke;
}

CameraView fuzzed_camera(Bytes& bytes) {
  CameraView view;
  view.azimuth_deg = 20 * bytes.number();
  view.elevation_deg = 10 * bytes.number();
  view.zoom = bytes.number();
  if (bytes.flag()) view.center = bytes.vector();
  return view;
}

constexpr const char* kMeshes[] = {"shape:torus,resolution=8",    "shape:sphere,resolution=1",
                                   "shape:cylinder,resolution=8", "shape:box,resolution=3",
                                   "shape:helicoid,resolution=8", "shape:grid,resolution=6",
                                   "shape:no-such-shape",         "no-such-file.ply"};

SessionCommand fuzzed_command(Bytes& bytes, Shown shown) {
  switch (bytes.below(24)) {
    case 0:
      return session_command("open", {{"mesh", kMeshes[bytes.below(std::size(kMeshes))]},
                                      {"keep_options", bytes.flag()}});
    case 1:
      return commands::show(kAllShown[bytes.below(kAllShown.size())]);
    case 2:
      return commands::add_stroke(fuzzed_stroke(bytes));
    case 3:
      return commands::change_stroke(bytes.below(3), fuzzed_stroke(bytes));
    case 4:
      return commands::erase_stroke(bytes.below(3));
    case 5:
      return commands::set_camera(fuzzed_camera(bytes));
    case 6:
      return session_command("set_size",
                             {{"size", size_to_json({16 * bytes.byte(), 16 * bytes.byte()})}});
    case 7:
      return commands::store_view(static_cast<int>(bytes.below(11)));
    case 8:
      return commands::recall_view(static_cast<int>(bytes.below(11)));
    case 9:
      return commands::set_frequency_by_zoom(bytes.number());
    case 10:
      return session_command("begin_drag");
    case 11:
      return session_command("end_drag");
    case 12:
      return session_command("undo");
    case 13:
      return session_command("redo");
    case 14:
      return session_command("solve_again");
    case 15:
      return session_command("previous_view");
    case 16:
      return session_command("next_view");
    default:
      return fuzzed_option(bytes, shown);
  }
}

void check_round_trip(const SessionDocument& document) {
  promise(document_from_json(document_to_json(document)) == document,
          "a document is the same when it was written and read");
}

bool is_one_of(const SessionCommand& command, const std::vector<std::string>& names) {
  const auto name = command.at("command").get<std::string>();
  return std::ranges::find(names, name) != names.end();
}

bool goes_back(const SessionCommand& command) {
  return is_one_of(command, {"undo", "redo", "previous_view", "next_view"});
}

/// A command, and that it changes what it may.
void check_applied(Session& session, const SessionCommand& command) {
  const SessionDocument before = session.document();
  const std::uint64_t revision = session.revision();
  if (!session.apply(command)) {
    promise(session.document() == before && session.revision() == revision,
            "what is refused changes nothing");
    return;
  }
  promise(session.document() == before || session.revision() > revision,
          "another document has another number");
  if (session.dragging() || session.document() == before) return;
  const SessionDocument after = session.document();
  if (is_one_of(command, {"set_camera", "recall_view"})) {
    promise(session.previous_view() && session.document().camera == before.camera,
            "the view before is where it was");
    promise(session.next_view() && session.document().camera == after.camera,
            "the next view is where it was");
    return;
  }
  if (goes_back(command) || !session.can_undo()) return;
  promise(session.undo() && session.document() == before, "undo restores what was");
  promise(session.redo() && session.document() == after, "redo restores what was undone");
  check_round_trip(after);
}

void check_state(const LiveState& state) {
  promise(std::isfinite(state.report().energy) && state.report().energy >= 0 &&
              state.report().energy <= 1,
          "energies are in [0, 1]");
  promise(state.job != nullptr, "a state has a pattern");
  for (const auto& [name, value] : state.metrics.shown) {
    promise(std::isfinite(value), "metrics are numbers");
  }
  if (!state.phases) return;
  for (const float angle : *state.phases) promise(std::isfinite(angle), "phases are numbers");
}

/// Makes the document's pattern, or cancels that at one of its reports.
void update(Bytes& bytes, LivePattern& pattern, Session& session) {
  const auto follow = static_cast<Follow>(bytes.below(3));
  const std::size_t last = bytes.flag() ? 4 * bytes.byte() : 100000;
  std::size_t reports = 0;
  const Progress progress([&](std::string_view, double) { return reports++ != last; });
  const auto before = pattern.state();
  try {
    refusing([&] { pattern.update(session.document(), follow, progress); });
  } catch (const Error& error) {
    promise(pattern.state() == before, "what was refused or cancelled leaves the last pattern");
    promise(std::string_view(error.what()).size() > 3, "an error says what is wrong");
    session.take_back(session.revision(), error.what());
    return;
  }
  check_state(*pattern.state());
  if (follow == Follow::afresh && !session.document().phases) {
    LivePattern other;
    other.update(session.document(), Follow::afresh);
    promise(
        other.state()->report().energy == pattern.state()->report().energy &&
            other.state()->report().quality.branches == pattern.state()->report().quality.branches,
        "a document alone says what its pattern is");
  }
}

}  // namespace

std::string session_text() {
  SessionDocument document;
  document.options["stripes"] = {"60"};
  document.options["slack"] = {"0.5"};
  document.curves["lines"] = {"both"};
  document.strokes.push_back({{{0, 0, 1}, {0.5, 0, 1}}, 0.1, 2});
  document.views[2] = CameraView{.azimuth_deg = 10};
  const auto path = scratch_path("seed.json");
  write_session(path, document);
  return content(path);
}

void run_session(std::span<const std::uint8_t> bytes) {
  refusing([&] {
    const SessionDocument document = read_session(scratch_file("session.json", bytes));
    const auto again = scratch_path("again.json"), third = scratch_path("third.json");
    write_session(again, document);
    const SessionDocument copy = read_session(again);
    promise(copy == document, "a session is the same when it was written and read");
    write_session(third, copy);
    promise(content(third) == content(again), "a session has the same bytes when written again");
  });
}

void run_commands(std::span<const std::uint8_t> bytes) {
  refusing([&] {
    const std::vector<SessionCommand> all = read_commands(scratch_file("commands.jsonl", bytes));
    const auto again = scratch_path("again.jsonl");
    write_commands(again, all);
    promise(read_commands(again) == all, "commands are the same when written and read");
    Session session;
    for (const SessionCommand& command : all) check_applied(session, command);
  });
}

void run_operations(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  SessionDocument document;
  document.mesh = kMeshes[bytes.below(6)];
  document.size = {64, 48};
  Session session(document);
  LivePattern pattern;
  for (int steps = 0; steps < 24 && !bytes.is_empty(); ++steps) {
    check_applied(session, fuzzed_command(bytes, session.document().shown));
    if (bytes.below(3) == 0) update(bytes, pattern, session);
  }
}

}  // namespace brindle::fuzz
