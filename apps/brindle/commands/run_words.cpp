#include "commands/run_words.h"

#include <algorithm>

#include "cli/commands.h"
#include "cli/option_parts.h"

namespace brindle::tool {

void run_words(std::vector<std::string> words) {
  CLI::App app{"", "brindle"};
  const std::vector<Command> commands = {add_stripe_command(app), add_curves_command(app),
                                         add_sample_command(app), add_animate_command(app)};
  words = command_line_with_parts_apart(app, words);
  std::ranges::reverse(words);  // CLI11's order
  app.parse(words);
  for (const Command& command : commands) {
    if (command.app->parsed()) command.run();
  }
}

}  // namespace brindle::tool
