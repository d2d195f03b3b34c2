// Whether the C++ library has threads: WebAssembly built without -pthread has none, nor the headers for them.
#pragma once

#if defined(__wasm__) && !defined(_REENTRANT)
#define LR_HAS_THREADS 0
#else
#define LR_HAS_THREADS 1
#include <thread>
#endif

namespace lr {

#if LR_HAS_THREADS
using ThreadId = std::thread::id;
inline ThreadId nobody() {
    return {};
}
inline ThreadId this_thread() {
    return std::this_thread::get_id();
}
inline unsigned hardware_threads() { // 0 where the system does not say
    return std::thread::hardware_concurrency();
}
#else
using ThreadId = int;
inline ThreadId nobody() {
    return -1;
}
inline ThreadId this_thread() {
    return 0;
}
inline unsigned hardware_threads() {
    return 1;
}
#endif

} // namespace lr
