/// One thread for BLAS, whichever library that is.
#pragma once

namespace brindle {

/// While one lives, BLAS works on the calling thread alone, so that its results depend neither on
/// the number of threads nor on how a library shares work among them. The library is found at run
/// time: OpenBLAS, MKL, BLIS or FlexiBLAS; others are taken for serial, as the reference BLAS is.
class SerialBlas {
 public:
  SerialBlas();
  ~SerialBlas();
  SerialBlas(const SerialBlas&) = delete;
  SerialBlas& operator=(const SerialBlas&) = delete;
};

}  // namespace brindle
