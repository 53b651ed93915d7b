/// One thread for BLAS, whichever library that is.
#pragma once

namespace brindle {

/// While one lives, BLAS works on the calling thread alone, so that its results depend neither on
/// the number of threads nor on how a library shares work among them. The library is found at run
/// time: OpenBLAS, MKL, BLIS or FlexiBLAS; others are taken for serial, as the reference BLAS is.
///
/// OpenBLAS takes a buffer at its first call, and tries for ever where there is no memory for it:
/// the constructor sees to it that the buffer is there. OpenMP, by which CHOLMOD fills its blocks,
/// ends the process where it cannot make a thread: while one lives it makes none on this thread.
class SerialBlas {
 public:
  /// Throws Error if there is no memory for what BLAS needs.
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;

 private:
  int levels_before_ = -1;  ///< of OpenMP's regions; -1: there is no OpenMP
};

}  // namespace brindle
