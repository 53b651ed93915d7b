// `brindle view` in builds without a window.
#include <string>
#include <vector>

#include "brindle/error.h"
#include "cli/commands.h"

namespace brindle::tool {
namespace {

struct ViewArguments {
  std::vector<std::string> meshes;
};

void add_view_options(CLI::App& command, ViewArguments& arguments) {
  command.add_option("MESH", arguments.meshes, "a mesh, a built-in shape or a session");
}

void run_view(const CLI::App&, const ViewArguments&) {
  throw Error(
      "this build has no window; install GLFW and Dear ImGui (libglfw3-dev, libimgui-dev), and "
      "configure with -DBRINDLE_WINDOW=ON; 'brindle render' draws sessions without a window");
}

}  // namespace

Command add_view_command(CLI::App& app) {
  return add_command<ViewArguments>(app, "view", "Open a window (not in this build)", "",
                                    add_view_options, run_view);
}

}  // namespace brindle::tool
