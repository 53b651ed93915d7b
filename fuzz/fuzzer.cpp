/// libFuzzer's entry: BRINDLE_FUZZ_TARGET says which target takes the bytes.
#include <cstdio>
#include <cstdlib>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace brindle::fuzz;
  static const Target* const target = [] {
    const char* name = std::getenv("BRINDLE_FUZZ_TARGET");
    const Target* found = name == nullptr ? nullptr : find_target(name);
    if (found == nullptr) {
      std::fputs("fuzzer: BRINDLE_FUZZ_TARGET names no target\n", stderr);
      std::exit(2);
    }
    return found;
  }();
  try {
    run(*target, {data, size});
  } catch (const BrokenPromise& broken) {
    std::fprintf(stderr, "broken promise: %s\n", broken.what.c_str());
    std::abort();
  }
  return 0;
}
