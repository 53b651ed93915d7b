/// What a shared library shows.
#pragma once

// On Windows a namespace has no such attribute: there CMake exports all symbols.
#if defined(__GNUC__) && !defined(_WIN32)
#define BRINDLE_EXPORT [[gnu::visibility("default")]]
#else
#define BRINDLE_EXPORT
#endif
