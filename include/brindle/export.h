/// What a shared library shows.
#pragma once

#if defined(__GNUC__)
#define BRINDLE_EXPORT [[gnu::visibility("default")]]
#else
#define BRINDLE_EXPORT
#endif
