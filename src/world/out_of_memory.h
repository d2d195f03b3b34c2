// Running out of memory in std::vector and its like becomes a status.
#pragma once

#include "langevin_rigid.h"

#include <new>
#include <utility>

namespace lr {

// LR_ERROR_OUT_OF_MEMORY where `body` runs out of it. WebAssembly is built without exceptions: there operator new leaves to the
// host instead (bindings/web/native/memory.cpp).
template <class F> lr_status unless_out_of_memory(F&& body) {
#if defined(__cpp_exceptions)
    try {
        return std::forward<F>(body)();
    } catch (const std::bad_alloc&) {
        return LR_ERROR_OUT_OF_MEMORY;
    }
#else
    return std::forward<F>(body)();
#endif
}

} // namespace lr
