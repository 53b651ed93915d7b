/// All vectors that a processor has, one kind after the other.
#pragma once

#ifdef BRINDLE_HAS_HIGHWAY

#include <cstdint>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace brindle::testing_support {

/// Calls `body` once for each instruction set that this build and this processor have; kernels then
/// use that one.
template <class Body>
void on_every_instruction_set(const Body& body) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    body();
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace brindle::testing_support

#endif
