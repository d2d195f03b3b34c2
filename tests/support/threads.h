// std::jthread, where the C++ library has threads: WebAssembly without -pthread has none, nor the headers for them.
#pragma once

#if defined(__wasm__) && !defined(_REENTRANT)
#define LR_TEST_THREADS 0
#else
#define LR_TEST_THREADS 1
#include <thread>
#endif
