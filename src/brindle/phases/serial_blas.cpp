#include "brindle/phases/serial_blas.h"

#include <array>
#include <cstdint>
#include <mutex>

#include <dlfcn.h>

namespace brindle {
namespace {

/// The two functions of a library that has its own threads, by the integer type they take.
template <class Integer>
struct ThreadControl {
  const char* getter;
  const char* setter;

  /// The number of threads so far; 0 if the library is not there.
  Integer set(Integer threads) const {
    using Get = Integer();
    using Set = void(Integer);
    auto* get = reinterpret_cast<Get*>(dlsym(RTLD_DEFAULT, getter));
    auto* set = reinterpret_cast<Set*>(dlsym(RTLD_DEFAULT, setter));
    if (!get || !set || threads <= 0) return 0;
    const Integer before = get();
    set(threads);
    return before;
  }
};

constexpr std::array<ThreadControl<int>, 3> kLibraries{
    {{"openblas_get_num_threads", "openblas_set_num_threads"},
     {"MKL_Get_Max_Threads", "MKL_Set_Num_Threads"},
     {"flexiblas_get_num_threads", "flexiblas_set_num_threads"}}};
constexpr ThreadControl<std::int64_t> kBlis{"bli_thread_get_num_threads",
                                            "bli_thread_set_num_threads"};

/// The libraries' numbers are the whole process's: the first one in changes them, the last one out
/// puts them back.
struct Shared {
  std::mutex mutex;
  int users = 0;
  std::array<int, kLibraries.size()> before{};
  std::int64_t blis_before = 0;
};

Shared& shared() {
  static Shared instance;
  return instance;
}

}  // namespace

SerialBlas::SerialBlas() {
  Shared& s = shared();
  const std::lock_guard lock(s.mutex);
  if (s.users++ > 0) return;
  for (std::size_t l = 0; l < kLibraries.size(); ++l) s.before[l] = kLibraries[l].set(1);
  s.blis_before = kBlis.set(1);
}

SerialBlas::~SerialBlas() {
  Shared& s = shared();
  const std::lock_guard lock(s.mutex);
  if (--s.users > 0) return;
  for (std::size_t l = 0; l < kLibraries.size(); ++l) kLibraries[l].set(s.before[l]);
  kBlis.set(s.blis_before);
}

}  // namespace brindle
