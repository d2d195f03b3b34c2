// std::jthread, if the C++ library has threads: WebAssembly without -pthread has neither threads nor their headers.
#pragma once

#if defined(__wasm__) && !defined(_REENTRANT)
#define LR_TEST_THREADS 0
#else
#define LR_TEST_THREADS 1
#include <thread>
#endif
