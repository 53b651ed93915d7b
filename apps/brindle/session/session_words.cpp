#include "session/session_words.h"

#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "cli/option_parts.h"
#include "cli/option_values.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

CameraView camera_of_words(const std::string& text) {
  const auto view = parse_camera_view(text);
  if (!view) throw Error("--camera " + text + ": is no AZIMUTH,ELEVATION[,ZOOM]");
  return *view;
}

Shown shown_by(const std::vector<std::string>& words) {
  const std::string command = words.empty() ? "" : words.front();
  for (const Shown shown : kAllShown) {
    if (command_of(shown) == command) return shown;
  }
  throw Error("a session has what 'brindle stripe', 'curves' and 'sample' draw, not '" + command +
              "'");
}

/// Options and their values without the command, with parts of values apart.
std::vector<std::string> options_of(const std::vector<std::string>& words, Shown shown) {
  SessionDocument any;
  any.shown = shown;
  return with_parts_apart(ParsedSession(any).command(), {words.begin() + 1, words.end()});
}

}  // namespace

SessionDocument document_of_words(const std::vector<std::string>& command_line) {
  SessionDocument document;
  document.shown = shown_by(command_line);
  document.mesh.clear();
  std::vector<std::string> words = options_of(command_line, document.shown);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      document.mesh = words[i];
      continue;
    }
    if (const std::size_t equals = words[i].find('='); equals != std::string::npos) {
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words[i].substr(equals + 1));
      words[i].resize(equals);
    }
    const std::string name = words[i].substr(2);
    const OptionInfo* option = find_session_option(name, document.shown);
    if (option != nullptr && option->kind == OptionKind::flag) {
      options_with(name, document)[name] = {};
      continue;
    }
    if (++i == words.size()) throw Error("--" + name + " lacks its value");
    if (name == "camera") {
      document.camera = camera_of_words(words[i]);
    } else {
      options_with(name, document)[name].push_back(words[i]);
    }
  }
  check_document(document);
  return document;
}

}  // namespace brindle::tool
