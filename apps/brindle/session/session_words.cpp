#include "session_words.h"

#include "brindle/error.h"
#include "option_values.h"
#include "session_options.h"

namespace brindle::tool {
namespace {

CameraView camera_of_words(const std::string& text) {
  const auto view = parse_camera_view(text);
  if (!view) throw Error("--camera " + text + ": is no AZIMUTH,ELEVATION[,ZOOM]");
  return *view;
}

}  // namespace

SessionDocument document_of_words(const std::vector<std::string>& words) {
  if (words.empty() || words.front() != "stripe") {
    throw Error("a session has what 'brindle stripe' draws, not '" +
                (words.empty() ? "" : words.front()) + "'");
  }
  SessionDocument document;
  document.mesh.clear();
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      document.mesh = words[i];
      continue;
    }
    const std::string name = words[i].substr(2);
    const SessionOption* option = find_session_option(name);
    if (option != nullptr && option->flag) {
      document.options[name] = {};
      continue;
    }
    if (++i == words.size()) throw Error("--" + name + " lacks its value");
    if (name == "camera") {
      document.camera = camera_of_words(words[i]);
    } else {
      check_option_name(name);
      document.options[name].push_back(words[i]);
    }
  }
  check_document(document);
  return document;
}

}  // namespace brindle::tool
