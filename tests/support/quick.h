// Fewer rounds and bodies where the library is slow: under sanitizers, and on WebAssembly.
#pragma once

#include <cstdlib>

inline bool quick() {
#ifdef LR_SLOW_LIBRARY // this program is built like it
    return true;
#else
    return std::getenv("LR_TEST_QUICK") != nullptr; // ./test.sh runs the release build's tests with such a library
#endif
}
