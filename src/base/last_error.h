// The text of the last failed call on each thread: lr_last_error.
#pragma once

#include <cstdio>

namespace lr {

inline constexpr size_t last_error_bytes = 256;
inline char* last_error() {
    static thread_local char text[last_error_bytes];
    return text;
}
inline void note_error(const char* function, const char* why) {
    std::snprintf(last_error(), last_error_bytes, "%s: %s", function, why);
}
} // namespace lr
