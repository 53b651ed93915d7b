/// Restricts BLAS to one thread, whichever library it is.
#pragma once

namespace brindle {

/// During its lifetime BLAS works on the calling thread alone, so that results depend neither on
/// the number of threads nor on how a library shares work among them. The library is found at run
/// time: OpenBLAS, MKL, BLIS or FlexiBLAS; others count as serial, like the reference BLAS.
///
/// OpenBLAS allocates a buffer at its first call and retries for ever if there is no memory, so the
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
  int levels_before_ = -1;  ///< of OpenMP's nested regions; -1: no OpenMP
};

}  // namespace brindle
