// std::bit_cast, which Emscripten's standard library lacks before LLVM 14, and so does Unity's web target.
#pragma once

#include <type_traits>

namespace lr {

template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}
} // namespace lr
