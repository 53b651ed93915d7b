#include "brindle/phases/serial_blas.h"

#include <optional>

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace brindle {
namespace {

TEST(SerialBlas, HoldsOpenBlasToOneThreadAndPutsItsNumberBack) {
  auto* get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  auto* set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  std::optional<SerialBlas> outer(std::in_place);
  if (get && set) {
    outer.reset();
    const int before = get();
    for (const int threads : {2, 3}) {
      set(threads);
      outer.emplace();
      EXPECT_EQ(get(), 1);
      { const SerialBlas inner; }
      EXPECT_EQ(get(), 1) << "the first one in still lives";
      outer.reset();
      EXPECT_EQ(get(), threads);
    }
    set(before);
  }
}

}  // namespace
}  // namespace brindle
