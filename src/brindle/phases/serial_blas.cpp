#include "brindle/phases/serial_blas.h"

#include <array>
#include <cstdint>
#include <mutex>
#include <string>

#include "brindle/base/system.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// The function of this name in the process, or null.
template <class Function>
Function* function_named(const char* name) {
  return reinterpret_cast<Function*>(system::function_named(name));
}

/// The functions of a library that get and set its number of threads.
template <class Integer>
struct ThreadControl {
  const char* getter;
  const char* setter;

  /// Sets the number of threads and returns the previous one; 0 if the library is not loaded.
  Integer set(Integer threads) const {
    auto* get = function_named<Integer()>(getter);
    auto* set = function_named<void(Integer)>(setter);
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

/// The number of threads is global: the first user changes it, the last one restores it.
struct Shared {
  std::mutex mutex;
  int users = 0;
  bool has_buffer = false;
  std::array<int, kLibraries.size()> before{};
  std::int64_t blis_before = 0;
};

Shared& shared() {
  static Shared instance;
  return instance;
}

/// Makes OpenBLAS allocate its permanent buffer while there is enough memory.
void take_buffer(Shared& s) {
  constexpr std::size_t kBuffer = std::size_t{160} << 20;  // 128 MB, aligned
  using Potrf = void(const char*, const std::int64_t*, double*, const std::int64_t*, std::int64_t*,
                     std::size_t);
  auto* const potrf = function_named<Potrf>("dpotrf_");
  if (s.has_buffer || !potrf || !function_named<int()>("openblas_get_num_threads")) return;
  if (!system::can_map(kBuffer)) {
    throw Error("there is no memory left for the " + std::to_string(kBuffer >> 20) +
                " MB that OpenBLAS needs; free some memory or use the multilevel solver");
  }
  // BLAS with 32-bit integers reads the first half, which is 1 as well.
  const std::int64_t one = 1;
  std::int64_t info = 0;
  double matrix = 1;
  potrf("L", &one, &matrix, &one, &info, 1);
  s.has_buffer = true;
}

}  // namespace

SerialBlas::SerialBlas() {
  Shared& s = shared();
  const std::lock_guard lock(s.mutex);
  take_buffer(s);
  auto* const get_levels = function_named<int()>("omp_get_max_active_levels");
  auto* const set_levels = function_named<void(int)>("omp_set_max_active_levels");
  if (get_levels && set_levels) {
    levels_before_ = get_levels();
    set_levels(0);
  }
  if (s.users++ > 0) return;
  for (std::size_t l = 0; l < kLibraries.size(); ++l) s.before[l] = kLibraries[l].set(1);
  s.blis_before = kBlis.set(1);
}

SerialBlas::~SerialBlas() {
  Shared& s = shared();
  const std::lock_guard lock(s.mutex);
  if (levels_before_ >= 0) {
    function_named<void(int)>("omp_set_max_active_levels")(levels_before_);
  }
  if (--s.users > 0) return;
  for (std::size_t l = 0; l < kLibraries.size(); ++l) kLibraries[l].set(s.before[l]);
  kBlis.set(s.blis_before);
}

}  // namespace brindle
