// The arguments of a call as a tuple, and the call with one pointer replaced.
#pragma once

#include "langevin_rigid_research.h"

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace test {

// Pointers that are required, and pointers that may be null.
template <class T> struct Must { T* pointer; };
template <class T> struct May { T* pointer; };
template <class T> Must<T> must(T* pointer) {
    return {pointer};
}
template <class T> May<T> may(T* pointer) {
    return {pointer};
}
template <class A> inline constexpr bool needed = false;
template <class T> inline constexpr bool needed<Must<T>> = true;
template <class A>
concept Pointer = requires(A a) {
    a.pointer;
};

// Calls with the pointer at the place `replaced` exchanged for `instead`.
template <class... P, class... A>
lr_status call(lr_status (*function)(P...), const std::tuple<A...>& arguments, size_t replaced = sizeof...(A),
               void* instead = nullptr) {
    const auto argument = [&]<size_t I, class T>(std::integral_constant<size_t, I>, T*) -> T {
        const auto& given = std::get<I>(arguments);
        if constexpr (Pointer<std::remove_cvref_t<decltype(given)>>)
            return I == replaced ? static_cast<T>(instead) : given.pointer;
        else
            return static_cast<T>(given);
    };
    return [&]<size_t... I>(std::index_sequence<I...>) {
        return function(argument(std::integral_constant<size_t, I>(), static_cast<P*>(nullptr))...);
    }
    (std::index_sequence_for<P...>());
}

} // namespace test
