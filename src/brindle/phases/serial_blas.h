/// Restricts any BLAS library to one thread.
#pragma once

namespace brindle {

/// During its lifetime BLAS runs on the calling thread alone. Results then depend neither on the
/// number of threads nor on how a library divides work. The library is found at run time: OpenBLAS,
/// MKL, BLIS or FlexiBLAS; others count as serial, like the reference BLAS.
///
/// OpenBLAS allocates a buffer at its first call and retries forever if memory runs out, so the
/// constructor makes sure that the buffer exists. OpenMP, which CHOLMOD uses to fill its blocks,
/// ends the process if it cannot create a thread, so it creates none on this thread.
class SerialBlas {
 public:
  /// Throws Error if there is no memory for the buffer.
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;

 private:
  int levels_before_ = -1;  ///< nesting levels of OpenMP before; -1: no OpenMP
};

}  // namespace brindle
