#include "ranks/first_rank.h"

#include <CLI/CLI.hpp>

#include "brindle/error.h"
#include "brindle/progress.h"

namespace brindle::tool {

void together_as_used(Communicator& ranks, const std::function<void()>& work) {
  bool wrong_usage = false;
  const auto noted = [&] {
    try {
      work();
    } catch (const CLI::ParseError& error) {
      wrong_usage = true;
      throw Error(error.what());
    }
  };
  try {
    ranks.throw_on_all(noted);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    if (ranks.any(wrong_usage))
      throw CLI::ValidationError(error.what(), CLI::ExitCodes::ValidationError);
    throw;
  }
}

void on_first_rank(Communicator& ranks, const std::function<void()>& work) {
  together_as_used(ranks, [&] {
    if (ranks.rank() == 0) work();
  });
}

}  // namespace brindle::tool
