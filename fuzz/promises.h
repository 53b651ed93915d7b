/// What must hold.
#pragma once

namespace brindle::fuzz {

/// Throws BrokenPromise unless it is kept.
void promise(bool kept, const char* what);

}  // namespace brindle::fuzz
